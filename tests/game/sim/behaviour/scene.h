// Scenes for tests that measure behaviour in the running game: the game's own rules, no waves, a ship that
// nothing can touch, and enemies put where the test wants them.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "game/sim/game_globals.h"
#include "game/sim/simulation.h"

namespace gw::test {

// In table order.
enum Type : uint32_t { kTriangle, kQuad, kHexagon, kVertex, kTexel, kFragment, kCompute };

Rules gameRules();

// The game's rules, but nothing spawns.
SimulationConfig quietConfig();

struct Place {
  uint32_t type = kTriangle;
  float x = 0, y = 0;  // m
  float energy = 0;    // 0: all it has
  State state = State::wandering;
  uint32_t flags = 0;
};

// A game late enough for no enemy to be announced. Headings are spread evenly over the ids.
std::unique_ptr<Simulation> makeScene(const SimulationConfig& config, float ship_x, float ship_y,
                                      const std::vector<Place>& places);

TickReport playOn(Simulation& simulation, uint32_t ticks, const InputRecord& input = {});

// Mean over all entities of a type of the distance to the nearest of that type, m.
double meanNearest_m(const Snapshot& snapshot, uint32_t type);

}  // namespace gw::test
