#include "tests/game/sim/game_runs.h"

#include <cmath>
#include <cstring>

namespace gw::test {

Snapshot snapshotOf(const naive::World& world) {
  Snapshot snapshot;
  snapshot.globals.resize(sizeof(GameGlobals));
  std::memcpy(snapshot.globals.data(), &world.globals, sizeof(GameGlobals));
  snapshot.entities = world.records();
  return snapshot;
}

GameGlobals globalsOf(const Snapshot& snapshot) {
  GameGlobals globals;
  std::memcpy(&globals, snapshot.globals.data(), sizeof globals);
  return globals;
}

Snapshot crowdScene(const SimulationConfig& config, uint32_t enemies, uint32_t seed) {
  naive::World world = StageFixture(config).emptyWorld();
  GameGlobals& m = world.globals;
  m.tick = m.waveClock_ticks = kLateTick;
  m.wave = 5;
  m.multiplierTenths = 400;
  Dice dice(seed);
  const float width = world.limits.width_m, height = world.limits.height_m;
  while (world.entities.size() < enemies) {
    const uint32_t type = dice.below(world.rules.enemyTypeCount);
    const float x = dice.between(2.0f, width - 2.0f), y = dice.between(2.0f, height - 2.0f);
    if (std::hypot(x - m.ship.x, y - m.ship.y) < 14.0f) continue;
    world.entities.push_back({enemyAt(world.rules, uint32_t(world.entities.size()), type, x, y)});
    ++m.totals.occupied[type];
  }
  return snapshotOf(world);
}

std::vector<TickReport> play(Simulation& simulation, uint32_t ticks, const std::vector<InputRecord>& inputs) {
  std::vector<TickReport> reports;
  for (uint32_t t = 0; t < ticks; ++t) {
    simulation.tick(t < inputs.size() ? inputs[t] : InputRecord{});
    reports.push_back(simulation.report());
  }
  return reports;
}

std::vector<uint64_t> hashesOf(const std::vector<TickReport>& reports) {
  std::vector<uint64_t> hashes;
  for (const TickReport& report : reports) hashes.push_back(report.hash);
  return hashes;
}

std::vector<InputRecord> inputsOf(const std::vector<TickReport>& reports) {
  std::vector<InputRecord> inputs;
  for (const TickReport& report : reports) inputs.push_back(report.input);
  return inputs;
}

}  // namespace gw::test
