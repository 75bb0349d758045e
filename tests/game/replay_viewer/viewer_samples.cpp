#include "viewer_samples.h"

#include "game/tables/tables.h"

namespace gw::test {

ViewerSample playedSample(uint32_t ticks, uint32_t enemies, Gather gather) {
  ViewerSample sample;
  ReplayHeader& header = sample.replay.header;
  header.seed = 3;
  header.mode = Mode::swarm;
  header.enemies = enemies;
  header.autopilot = Autopilot::expert;
  header.gather = gather;
  sample.replay.rules = readRuleTexts(GW_ASSETS_DIR);
  sample.config = replayConfig(sample.replay);
  sample.config.threads = 1;
  sample.config.particles = true;

  SimulationConfig recorded = sample.config;
  recorded.autopilot = Autopilot::expert;
  Run run(cpu::makeSimulation(recorded), std::nullopt);
  const auto remember = [&] {
    sample.monitors.push_back(run.monitor());
    sample.effects.push_back(run.effects());
    sample.flying.push_back(run.simulation().particles());
  };
  remember();
  while (run.last().tick < ticks && !run.over()) {
    run.tick({});
    sample.replay.inputs.push_back(run.last().input);
    sample.replay.hashes.push_back(run.last().hash);
    remember();
  }
  const TickReport& last = run.last();
  sample.replay.result = {last.score, last.kills, last.frameTime_us, last.over != 0};
  return sample;
}

}  // namespace gw::test
