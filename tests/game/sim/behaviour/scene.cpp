#include "tests/game/sim/behaviour/scene.h"

#include <algorithm>
#include <cstring>

#include "game/tables/tables.h"

namespace gw::test {

namespace {
constexpr uint32_t kLate_ticks = 1000;  // long after the birth of all
}

Rules gameRules() {
  return loadRules(readRuleTexts(GW_ASSETS_DIR));
}

SimulationConfig quietConfig() {
  SimulationConfig config;
  config.rules = gameRules();
  config.enemies = 512;
  config.threads = 1;  // small games
  config.rules.waveCount = 0;
  config.rules.endless.from_ticks = ~0u;
  config.rules.idle.fewerThan = 0;
  return config;
}

std::unique_ptr<Simulation> makeScene(const SimulationConfig& config, float ship_x, float ship_y,
                                      const std::vector<Place>& places) {
  auto simulation = cpu::makeSimulation(config);
  Snapshot scene = simulation->snapshot();
  GameGlobals globals;
  std::memcpy(&globals, scene.globals.data(), sizeof globals);
  globals.tick = kLate_ticks;
  globals.ship.x = globals.ship.previous_x = ship_x;
  globals.ship.y = globals.ship.previous_y = ship_y;
  globals.ship.untouchable_ticks = 1u << 30;
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
  for (const Place& place : places) {
    const EnemyRules& rules = config.rules.enemies[place.type];
    EntityRecord e{};
    e.id = uint32_t(scene.entities.size());
    e.type = place.type;
    e.x = e.previous_x = place.x;
    e.y = e.previous_y = place.y;
    const double heading_rad = 2.399963 * e.id;  // the golden angle
    e.direction_x = float(std::cos(heading_rad));
    e.direction_y = float(std::sin(heading_rad));
    e.energy = place.energy > 0 ? place.energy : rules.energy;
    e.mass = rules.mass;
    e.state = uint32_t(place.state);
    e.flags = place.flags;
    e.target = kNobody;
    scene.entities.push_back(e);
  }
  simulation->restore(scene);
  return simulation;
}

TickReport playOn(Simulation& simulation, uint32_t ticks, const InputRecord& input) {
  TickReport report;
  for (uint32_t t = 0; t < ticks; ++t) {
    simulation.tick(input);
    report = simulation.report();
  }
  return report;
}

double meanNearest_m(const Snapshot& snapshot, uint32_t type) {
  double sum = 0;
  uint32_t count = 0;
  for (const EntityRecord& e : snapshot.entities) {
    if (e.type != type) continue;
    double nearest = INFINITY;
    for (const EntityRecord& other : snapshot.entities) {
      if (other.type == type && other.id != e.id) {
        nearest = std::min(nearest, std::hypot(double(e.x) - double(other.x), double(e.y) - double(other.y)));
      }
    }
    sum += nearest;
    ++count;
  }
  return sum / count;
}

}  // namespace gw::test
