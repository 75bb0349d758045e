#include "bench/scenes.h"

#include <cmath>
#include <cstring>
#include <random>

#include "bench/fingerprint.h"
#include "game/sim/behaviour/state_tables.h"
#include "game/sim/game_globals.h"
#include "game/tables/tables.h"

namespace gw::bench {

namespace {
constexpr uint32_t kSwarmTicks = 1200, kMixedTicks = 300;

void makeUntouchable(Snapshot& scene) {
  GameGlobals globals;
  std::memcpy(&globals, scene.globals.data(), sizeof globals);
  globals.ship.untouchable_ticks = 1u << 30;
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
}
}  // namespace

SimulationConfig configFor(uint32_t enemies, uint32_t threads, Scene scene, const std::filesystem::path& assets) {
  SimulationConfig config;
  config.rules = loadRules(readRuleTexts(assets.empty() ? GW_ASSETS_DIR : assets));
  config.enemies = enemies;
  config.threads = threads;
  const bool mixed = scene == Scene::mixed || scene == Scene::horde;
  if (mixed) config.mode = Mode::swarm;  // brings them all in its first tick, and none after
  Rules& rules = config.rules;
  rules.waveCount = 0;
  rules.endless.from_ticks = ~0u;
  rules.idle.fewerThan = 0;
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) {
    if (scene == Scene::uniform) rules.enemies[t].sight_m = t == 0 ? 1.0e6f : 0.0f;
    if (scene == Scene::swarm || scene == Scene::horde) rules.enemies[t].sight_m = 1.0e6f;
    rules.enemies[t].contact_us = 0;
  }
  return config;
}

Snapshot sceneOf(Scene scene, Simulation& sim, const SimulationConfig& config) {
  switch (scene) {
    case Scene::uniform:
      return uniformScene(sim, config);
    case Scene::swarm:
      return swarmScene(sim, config);
    case Scene::mixed:
      return mixedScene(sim, kMixedTicks);
    default:
      return mixedScene(sim, kSwarmTicks);
  }
}

Snapshot uniformScene(Simulation& sim, const SimulationConfig& config) {
  Snapshot scene = sim.snapshot();
  scene.arrangement.clear();  // of the empty game: the scene gets one of its own
  GameGlobals globals;
  std::memcpy(&globals, scene.globals.data(), sizeof globals);
  globals.tick = 1000;
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
  makeUntouchable(scene);
  uint32_t kamikazes = 0;  // they stand first in the table
  while (kamikazes < config.rules.enemyTypeCount && config.rules.enemies[kamikazes].machine == Machine::kamikaze) {
    ++kamikazes;
  }

  const double area = config.enemies / 0.395, shape = sim.worldWidth_m() / sim.worldHeight_m();
  const double height = std::min<double>(sim.worldHeight_m() - 4.0, std::sqrt(area / shape));
  const double width = std::min<double>(sim.worldWidth_m() - 4.0, area / height);
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (uint32_t id = 0; id < config.enemies; ++id) {
    EntityRecord e{};
    e.id = id;
    e.type = unit(random) < 0.7 ? 0u : 1u + uint32_t(random() % (kamikazes - 1));
    const EnemyRules& rules = config.rules.enemies[e.type];
    e.x = e.previous_x = float(0.5 * sim.worldWidth_m() + (unit(random) - 0.5) * width);
    e.y = e.previous_y = float(0.5 * sim.worldHeight_m() + (unit(random) - 0.5) * height);
    const double angle = unit(random) * 6.283185307;
    e.direction_x = float(std::cos(angle));
    e.direction_y = float(std::sin(angle));
    e.velocity_x = e.direction_x * rules.speed_mps * 0.6f;
    e.velocity_y = e.direction_y * rules.speed_mps * 0.6f;
    e.energy = rules.energy;
    e.mass = rules.mass;
    e.state = uint32_t(e.type == 0 ? State::attacking : State::wandering);
    e.target = kNobody;
    scene.entities.push_back(e);
  }
  return scene;
}

Snapshot swarmScene(Simulation& sim, const SimulationConfig& config) {
  sim.restore(uniformScene(sim, config));
  playOn(sim, kSwarmTicks);
  return sim.snapshot();
}

Snapshot mixedScene(Simulation& sim, uint32_t ticks) {
  playOn(sim, 1);
  Snapshot scene = sim.snapshot();
  makeUntouchable(scene);
  scene.arrangement.clear();
  sim.restore(scene);
  playOn(sim, ticks);
  return sim.snapshot();
}

uint64_t playOn(Simulation& sim, uint32_t ticks) {
  Fingerprint hashes;
  for (uint32_t t = 0; t < ticks; ++t) {
    sim.tick({});
    hashes.add(sim.report().hash);
  }
  return hashes.value();
}

}  // namespace gw::bench
