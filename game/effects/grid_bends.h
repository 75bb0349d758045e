// What bends the background: kills send small ripples, a contact a large one, the flush its ring, and the
// ship draws a gentle wake behind it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "game/effects/effect_time.h"
#include "game/sim/simulation.h"
#include "render/grid_bend.h"

namespace gw {

class GridBends {
 public:
  void add(const TickReport& report);

  // At most kMaxGridBends: the wake first, then those that bend most at this moment.
  std::vector<GridBend> at(const EffectTime& time) const;

  // A ring that runs outwards and fades.
  struct Ripple {
    float x = 0, y = 0;
    uint32_t tick = 0;
    float speed_mps = 0;
    float width_m = 1, strength_m = 0;  // at the start
    float life_s = 1;
  };

 private:
  // Sixteen are shown; a few more wait for their turn while stronger ones fade.
  static constexpr size_t kRipples = 64;

  void start(const Ripple& ripple);

  std::array<Ripple, kRipples> ripples_{};  // a ring: the oldest goes
  size_t next_ = 0;
  float ship_x_ = 0, ship_y_ = 0, shipPrevious_x_ = 0, shipPrevious_y_ = 0;
  float wake_x_ = 0, wake_y_ = 0, wakeBefore_x_ = 0, wakeBefore_y_ = 0;  // smoothed velocity, m/s
};

}  // namespace gw
