// The best of this session in each mode. In swarm the time is the score, and only a cleared field counts;
// practice has none.
#pragma once

#include <array>
#include <string>

#include "game/sim/simulation.h"
#include "game/ui/mode_choice.h"

namespace gw {

struct Best {
  uint64_t score = 0;
  uint32_t cleared_ticks = 0;  // swarm
};                             // zeros: none

// Whether the run that ended so is better.
bool beats(Mode mode, const TickReport& report, const Best& best);

// "12,345", in swarm "3:12.4"; empty: none.
std::string bestText(Mode mode, const Best& best);

class SessionBest {
 public:
  const Best& of(Mode mode) const { return best_[uint32_t(mode)]; }
  void enter(Mode mode, const TickReport& report);

 private:
  std::array<Best, kModeCount> best_{};
};

}  // namespace gw
