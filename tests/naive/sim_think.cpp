#include <cmath>

#include "game/sim/entity_flags.h"
#include "gpu/exact_math.h"
#include "gpu/philox.h"
#include "tests/naive/sim_world.h"

namespace gw::naive {
namespace {

constexpr uint32_t kWanderPurpose = 3;

struct Vector {
  float x, y;
};

Vector unit(float x, float y) {
  const float l = std::sqrt(x * x + y * y);
  return l > 0.0f ? Vector{x / l, y / l} : Vector{0.0f, 0.0f};
}

// RULES: heading drifts, with a share towards the ship, at a share of the speed; attacking seeks the ship,
// faster when damaged. The force closes a share of the gap to that wish in one tick.
void steer(const World& world, Entity& e) {
  const Rules& r = world.rules;
  const EnemyRules& type = world.rulesOf(e);
  const Vector toShip = unit(world.master.ship.x - e.x, world.master.ship.y - e.y);
  Vector way = toShip, heading = toShip;
  float speed = type.speed_mps;
  if (e.state == uint32_t(Kamikaze::attacking)) {
    if (e.energy < type.energy) speed = speed * r.steering.damagedSpeed;
  } else {
    const uint32_t dice = cpu::philox(world.master.seed, {world.master.tick, e.id, kWanderPurpose, 0}).x;
    const float drift = (2.0f * cpu::unitFloat(dice) - 1.0f) * r.steering.wanderDrift_rad;
    const float s = cpu::sine(drift), c = cpu::cosine(drift);
    heading = unit(e.direction_x * c - e.direction_y * s, e.direction_x * s + e.direction_y * c);
    way = unit(heading.x + r.steering.wanderToShip * toShip.x, heading.y + r.steering.wanderToShip * toShip.y);
    speed = speed * r.steering.wanderSpeed;
  }
  const float share = e.mass * r.steering.response * 60.0f;
  e.force_x = (way.x * speed - e.velocity_x) * share;
  e.force_y = (way.y * speed - e.velocity_y) * share;
  e.direction_x = heading.x;
  e.direction_y = heading.y;
}

void thinkEnemy(const World& world, Entity& e) {
  if (world.isAnnounced(e)) return;
  const float x = world.master.ship.x - e.x, y = world.master.ship.y - e.y, distance = std::sqrt(x * x + y * y);
  const float sight = world.rulesOf(e).sight_m;
  const Kamikaze before = Kamikaze(e.state);
  const Kamikaze after = kamikazeStep(before, e.flags & kFlagHit, e.energy <= 0.0f, distance <= sight,
                                      distance > sight * world.rules.steering.sightLost);
  e.state = uint32_t(after);
  e.transited = after != before;
  e.died = e.transited && after == Kamikaze::dead;
  if (after == Kamikaze::checkingEnergy) e.flags &= ~uint32_t(kFlagHit);
  if (after != Kamikaze::dead) steer(world, e);
}

void thinkBit(const World& world, Entity& e) {
  const Rules::Bit& bit = world.rules.bit;
  const float x = world.master.ship.x - e.x, y = world.master.ship.y - e.y, distance = std::sqrt(x * x + y * y);
  if (distance <= bit.take_m) {
    e.taken = true;
  } else if (distance <= bit.attract_m) {
    e.velocity_x = x / distance * bit.speed_mps;
    e.velocity_y = y / distance * bit.speed_mps;
  } else {
    e.velocity_x *= 0.94f;
    e.velocity_y *= 0.94f;
  }
}

}  // namespace

Kamikaze kamikazeStep(Kamikaze state, bool damaged, bool energyGone, bool seesShip, bool lostShip) {
  switch (state) {
    case Kamikaze::dead:
      return Kamikaze::dead;
    case Kamikaze::checkingEnergy:
      if (damaged) return Kamikaze::checkingEnergy;
      if (energyGone) return Kamikaze::dead;
      return seesShip ? Kamikaze::attacking : Kamikaze::wandering;
    case Kamikaze::wandering:
      if (damaged) return Kamikaze::checkingEnergy;
      return seesShip ? Kamikaze::attacking : Kamikaze::wandering;
    case Kamikaze::attacking:
      if (damaged) return Kamikaze::checkingEnergy;
      return lostShip ? Kamikaze::wandering : Kamikaze::attacking;
  }
  return state;
}

void think(World& world) {
  for (Entity& e : world.entities) {
    e.taken = e.died = e.transited = e.gone = false;
    if (world.isEnemy(e)) thinkEnemy(world, e);
    if (e.type == kTypeBit) thinkBit(world, e);
  }
}

}  // namespace gw::naive
