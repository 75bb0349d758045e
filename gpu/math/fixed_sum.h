// Sums over neighbours that do not mind the order: each term becomes an integer, integers are added, the
// sum becomes a float once. A term is clamped to +-2^30 units and truncated, which is odd (term(-x) ==
// -term(x)), so that the two halves of a pair force cancel to the last bit. 2^33 terms fit.
#pragma once

#include <gpuwars/device.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// Units per physical unit, each a power of two, so that scaling is exact. What a term can reach before it
// is clamped is 2^30 / scale.
inline constexpr float kPushScale = 1048576.0f;   // 2^20 per m/s: clamps at 1024 m/s, resolves 1e-6 m/s
inline constexpr float kSteerScale = 1048576.0f;  // 2^20 per m, or per unit vector: clamps at 1024, resolves 1e-6

GW_FN int32_t fixedTerm(float value, float scale) {
  const float units = value * scale;
  if (!(units > -1073741824.0f)) return units != units ? 0 : -1073741824;
  if (!(units < 1073741824.0f)) return 1073741824;
  return int32_t(units);
}

struct FixedSum2 {
  int64_t x = 0, y = 0;

  GW_MEMBER void add(float dx, float dy, float scale) {
    x += fixedTerm(dx, scale);
    y += fixedTerm(dy, scale);
  }
  GW_MEMBER Float2 total(float scale) const { return {float(x) / scale, float(y) / scale}; }
};

}  // namespace gw::GW_DEVICE
