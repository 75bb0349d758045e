// Keeps a practice run at a number of enemies: asks for what is missing with every second tick's input, types by turns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "game/sim/input_record.h"

namespace gw::profile {

class Refill {
 public:
  // `types`: of the enemy table; `fit`: the most that can live.
  Refill(uint32_t types, uint32_t fit) : types_(types), most_(std::max(1u, fit / types)) {}

  // Buttons of the next tick, when `live` of `wanted` are there. `exactly`: never more than are missing; else what is
  // too much is refused by the game, which cuts it to what fits.
  uint16_t buttons(uint32_t live, uint32_t wanted, bool exactly) {
    pressed_ = !pressed_ && live < wanted;  // the game takes the press, not the holding
    if (!pressed_) return 0;
    const uint32_t missing = std::min(wanted - live, most_);
    const uint32_t* end = std::end(kPracticeCounts);
    const uint32_t* count = std::lower_bound(std::begin(kPracticeCounts), end, missing);
    const bool tooMany = count == end || (*count > missing && (exactly || missing == most_));
    if (tooMany) --count;  // there is a lower one: 1 is never too many
    const uint32_t type = next_++ % types_;
    return uint16_t(kButtonSpawn | type << kSpawnTypeShift | uint32_t(count - kPracticeCounts) << kSpawnCountShift);
  }

 private:
  uint32_t types_, most_;  // most_: at a time, so that all types come early
  uint32_t next_ = 0;
  bool pressed_ = false;
};

}  // namespace gw::profile
