// What is thrown in a tick, by the table in docs/design/effects.md, one source after the other.
#pragma once

#include <vector>

#include "game/sim/draw/particle.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {

// Something that throws particles: an entity, by its id.
struct Happened {
  enum What { death, hit, taken } what;
  uint32_t id;
  float x, y;
  float motion_x = 0, motion_y = 0;  // of a shot that hits
  uint32_t type = 0;                 // of an enemy that dies
};

// By ascending id, and the ship's own last. `scratch` says what befell the ship.
std::vector<Particle> thrown(const World& world, const std::vector<Happened>& happened, const TickScratch& scratch);

}  // namespace gw::naive
