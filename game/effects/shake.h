// Screen shake by trauma: what happens adds to it, it wears off steadily, and the picture moves by its square,
// so that small things hardly show and large ones do. Moves what is drawn, never what is aimed at.
#pragma once

#include "game/effects/effect_time.h"
#include "game/sim/simulation.h"

namespace gw {

class Shake {
 public:
  static constexpr float kMost_m = 1.1f;  // in each direction, of a view 40 m high

  void add(const TickReport& report);

  struct Offset {
    float x = 0, y = 0;  // m
  };
  // `scale` 0 to 1; 0 is exactly no offset.
  Offset at(const EffectTime& time, float scale) const;

 private:
  float trauma_ = 0;  // 0 to 1, at the end of tick_
  uint32_t tick_ = 0;
};

}  // namespace gw
