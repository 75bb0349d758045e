// When an effect is looked at. Effects know no other clock: paused or withheld ticks hold them too, and the
// same moment of the same run always looks the same.
#pragma once

#include <cstdint>

#include "game/sim/rules.h"

namespace gw {

struct EffectTime {
  uint32_t tick = 0;      // ticks completed
  float since_ticks = 1;  // passed since then: a share of one, and more once the run is over

  // Ticks from the end of `earlier`; negative never.
  float after_ticks(uint32_t earlier) const { return float(tick - earlier) + since_ticks; }
  float after_s(uint32_t earlier) const { return after_ticks(earlier) * kTick_s; }
};

}  // namespace gw
