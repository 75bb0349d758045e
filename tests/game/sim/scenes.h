// Entities and scenes made by hand or by chance, for the tests of the stages.
#pragma once

#include <random>

#include "tests/reference/sim_world.h"

namespace gw::test {

// Far past the announcement of anything born at tick 0.
inline constexpr uint32_t kLateTick = 1000;

// A living enemy at rest, born long ago, wandering towards +x.
EntityRecord enemyAt(const Rules& rules, uint32_t id, uint32_t type, float x, float y);
// A shot on its way at the rules' speed, at full life, for this many hits.
EntityRecord shotAt(const Rules& rules, uint32_t id, float x, float y, float angle_rad, uint32_t hits = 1);
EntityRecord bitAt(const Rules& rules, uint32_t id, float x, float y);

// Numbers that are the same on every machine: the standard fixes the engine, not the distributions.
class Dice {
 public:
  explicit Dice(uint32_t seed) : engine_(seed) {}
  uint32_t below(uint32_t n) { return uint32_t(engine_() % n); }
  float between(float low, float high) { return low + (high - low) * float(engine_() >> 8) / 16777216.0f; }

 private:
  std::mt19937 engine_;
};

// A crowd round the ship: enemies of all types and states, some announced, some hit or dead, some lying on
// top of each other; shots with up to three hits left; bits. Ids have gaps.
void addCrowd(naive::World& world, uint32_t enemies, uint32_t shots, uint32_t bits, float halfWidth_m, Dice& dice);

}  // namespace gw::test
