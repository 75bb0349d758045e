// Points that rise from where they were scored. A number stands for the kills it was made of: those near each
// other within a moment share one, so that a horde's end stays readable. (Of several kills in one tick on
// one side of the ship the report names only the costliest.)
#pragma once

#include <vector>

#include "game/effects/effect_time.h"
#include "game/sim/simulation.h"

namespace gw {

class ScorePops {
 public:
  static constexpr size_t kMost = 24;
  static constexpr uint32_t kLife_ticks = 54;
  static constexpr uint32_t kMerges_ticks = 16;  // a number takes in others for this long
  static constexpr float kMerges_m = 4;

  void add(const TickReport& report);

  struct Shown {
    float x, y;  // m, of the middle
    uint64_t points;
    float size;     // of capitals, in canvas units
    float opacity;  // 0 to 1
  };
  // The oldest first.
  std::vector<Shown> at(const EffectTime& time) const;

 private:
  struct Number {
    float x, y;
    uint64_t points;
    uint32_t tick;     // when it was made
    uint32_t grownAt;  // when it last took one in
  };
  bool join(const Pop& pop, uint32_t tick);
  void makeRoom(uint32_t tick);

  std::vector<Number> numbers_;  // by age, the oldest first
};

}  // namespace gw
