#include "game/replay/replay.h"

#include "game/tables/tables.h"

namespace gw {

SimulationConfig replayConfig(const Replay& replay) {
  SimulationConfig config;
  config.rules = loadRules(replay.rules);
  config.seed = replay.header.seed;
  config.mode = replay.header.mode;
  config.enemies = replay.header.enemies;
  config.autopilot = Autopilot::none;
  config.gather = replay.header.gather;
  if (config.gather != Gather::exact) config.sort = replay.header.sort;
  return config;
}

}  // namespace gw
