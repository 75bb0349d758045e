// Small replays to watch, and what plain playing shows of them.
#pragma once

#include <memory>
#include <vector>

#include "game/replay/replay.h"
#include "game/session/run.h"

namespace gw::test {

struct ViewerSample {
  Replay replay;
  SimulationConfig config;                    // that plays it again
  std::vector<RunMonitor> monitors;           // [t] after tick t
  std::vector<RunEffects> effects;            // likewise
  std::vector<std::vector<Particle>> flying;  // likewise: the sparks

  std::unique_ptr<Simulation> simulation() const { return cpu::makeSimulation(config); }
};

// An expert among 96 enemies of a swarm, for so many ticks or to the end.
ViewerSample playedSample(uint32_t ticks, uint32_t enemies = 96, Gather gather = Gather::exact);

}  // namespace gw::test
