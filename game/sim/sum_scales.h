// The scales of the game's sums over neighbours (gpu/math/fixed_sum.h): units per physical unit, each a power of two,
// so that scaling is exact. What a term can reach before it is clamped is 2^30 / scale. Another scale is another game.
#pragma once

#include "gpu/exec/device.h"

namespace gw::GW_DEVICE {

inline constexpr float kPushScale = 1048576.0f;   // 2^20 per m/s: clamps at 1024 m/s, resolves 1e-6 m/s
inline constexpr float kSteerScale = 1048576.0f;  // 2^20 per m, or per unit vector: clamps at 1024, resolves 1e-6

}  // namespace gw::GW_DEVICE
