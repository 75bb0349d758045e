// Which moments of a run become pictures.
#pragma once

#include <cstdint>
#include <vector>

#include "game/sim/rules.h"

namespace gw {

struct FrameRange {
  uint32_t from = 1, to = 1;      // ticks, both drawn
  uint32_t framesPerSecond = 60;  // 30, 60 or 120: of kTicksPerSecond a share or a multiple
};

// The shares of a tick's motion at which it is drawn: none, {1}, or {0.5, 1}.
inline std::vector<float> framesOf(uint32_t tick, const FrameRange& range) {
  if (tick < range.from || tick > range.to) return {};
  const uint32_t each = range.framesPerSecond / kTicksPerSecond;  // frames a tick
  if (each == 0) {
    const uint32_t every = kTicksPerSecond / range.framesPerSecond;
    return (tick - range.from) % every == 0 ? std::vector<float>{1.0f} : std::vector<float>{};
  }
  std::vector<float> shares;
  for (uint32_t k = 1; k <= each; ++k) shares.push_back(float(k) / float(each));
  return shares;
}

inline uint64_t frameCount(const FrameRange& range) {
  const uint64_t ticks = uint64_t(range.to) - range.from + 1;
  const uint64_t each = range.framesPerSecond / kTicksPerSecond;
  if (each > 0) return ticks * each;
  const uint64_t every = kTicksPerSecond / range.framesPerSecond;
  return (ticks + every - 1) / every;
}

}  // namespace gw
