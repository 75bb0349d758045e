// Scenes that benches measure on, and how they time them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

#include "game/sim/simulation.h"
#include "host/platform/clock.h"

namespace gw::bench {

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

template <class Work>
double milliseconds(const Work& work) {
  const double begin_ms = now_ms();
  work();
  return now_ms() - begin_ms;
}

enum class Scene { uniform, swarm, mixed, horde };
constexpr const char* nameOf(Scene scene) {
  constexpr const char* kNames[] = {"uniform", "swarm", "mixed", "horde"};
  return kNames[int(scene)];
}

// The game's own rules, but nothing costs the ship anything. Uniform and swarm: the first type always sees the ship,
// the others only in a swarm; nothing else spawns. Horde: all see it.
SimulationConfig configFor(uint32_t enemies, uint32_t threads, Scene scene,
                           const std::filesystem::path& assets = {});  // empty: the source tree's

Snapshot sceneOf(Scene scene, Simulation& sim, const SimulationConfig& config);

// Kamikazes at 0.395 per square metre, which puts 20 within 4 m, around the middle of the world.
Snapshot uniformScene(Simulation& sim, const SimulationConfig& config);

// The same after 20 s, in which all of them have attacked an untouchable ship.
Snapshot swarmScene(Simulation& sim, const SimulationConfig& config);

// All seven types in the arcade's mix, spread over the world, after 5 s of the game as it is; as a horde after 20 s, in
// which all of them have attacked.
Snapshot mixedScene(Simulation& sim, uint32_t ticks);

// Ticks one by one, as a window would ask for them. The fingerprint of the state's hash after each of them.
uint64_t playOn(Simulation& sim, uint32_t ticks);

}  // namespace gw::bench
