#include "tests/game/sim/scenes.h"

#include <algorithm>

#include "game/sim/behaviour/state_tables.h"
#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"

namespace gw::test {

EntityRecord enemyAt(const Rules& rules, uint32_t id, uint32_t type, float x, float y) {
  EntityRecord e{};
  e.id = id;
  e.type = type;
  e.x = e.previous_x = x;
  e.y = e.previous_y = y;
  e.energy = rules.enemies[type].energy;
  e.mass = rules.enemies[type].mass;
  e.direction_x = 1.0f;
  e.target = kNobody;
  return e;
}

EntityRecord shotAt(const Rules& rules, uint32_t id, float x, float y, float angle_rad, uint32_t hits) {
  EntityRecord e{};
  e.id = id;
  e.type = kTypeShot;
  e.x = e.previous_x = x;
  e.y = e.previous_y = y;
  e.direction_x = cpu::cosine(angle_rad);
  e.direction_y = cpu::sine(angle_rad);
  e.velocity_x = e.direction_x * rules.shot.speed_mps;
  e.velocity_y = e.direction_y * rules.shot.speed_mps;
  e.energy = rules.shot.damage;
  e.timer = rules.shot.life_ticks;
  e.cooldown = hits;
  e.flags = e.target = kNobody;
  return e;
}

EntityRecord bitAt(const Rules& rules, uint32_t id, float x, float y) {
  EntityRecord e{};
  e.id = id;
  e.type = kTypeBit;
  e.x = e.previous_x = x;
  e.y = e.previous_y = y;
  e.velocity_x = 3.0f;
  e.direction_x = 1.0f;
  e.energy = 1.0f;
  e.timer = rules.bit.life_ticks;
  e.target = kNobody;
  return e;
}

namespace {
uint32_t livingState(Machine machine, Dice& dice) {
  for (;;) {
    const uint32_t state = dice.below(uint32_t(State::dead));
    bool known = false;
    for (uint32_t row = 0; row < tableOf(machine).count; ++row) {
      known = known || (tableOf(machine).rows[row].from & in(State(state)));
    }
    if (known) return state;
  }
}
}  // namespace

void addCrowd(naive::World& world, uint32_t enemies, uint32_t shots, uint32_t bits, float halfWidth_m, Dice& dice) {
  const Ship& ship = world.globals.ship;
  const Rules& rules = world.rules;
  uint32_t id = dice.below(3);
  const auto x = [&] {
    return std::clamp(ship.x + dice.between(-halfWidth_m, halfWidth_m), 2.0f, world.limits.width_m - 2.0f);
  };
  const auto y = [&] {
    return std::clamp(ship.y + dice.between(-halfWidth_m, halfWidth_m), 2.0f, world.limits.height_m - 2.0f);
  };
  for (uint32_t i = 0; i < enemies; ++i, id += 1 + dice.below(3) / 2) {
    const uint32_t type = dice.below(rules.enemyTypeCount);
    EntityRecord e = enemyAt(rules, id, type, x(), y());
    if (i > 0 && dice.below(16) == 0) {  // exactly where the one before stands
      e.x = e.previous_x = world.entities.back().x;
      e.y = e.previous_y = world.entities.back().y;
    }
    e.velocity_x = dice.between(-12.0f, 12.0f);
    e.velocity_y = dice.between(-12.0f, 12.0f);
    const float angle = dice.between(-3.0f, 3.0f);
    e.direction_x = cpu::cosine(angle);
    e.direction_y = cpu::sine(angle);
    e.push_x = dice.between(-4.0f, 4.0f);
    e.push_y = dice.between(-4.0f, 4.0f);
    e.state = dice.below(16) == 0 ? uint32_t(State::dead) : livingState(rules.enemies[type].machine, dice);
    if (e.state == uint32_t(State::avoiding)) e.timer = 1 + dice.below(rules.steering.avoid_ticks);
    if (rules.enemies[type].machine != Machine::kamikaze && dice.below(3) == 0) e.cooldown = dice.below(90);
    e.flags = dice.below(4) == 0 ? uint32_t(kFlagHit) : 0u;
    if (e.state == uint32_t(State::dead)) e.flags |= dice.below(4) * kFlagFlushed;
    if (dice.below(4) == 0) e.energy = dice.between(-1.0f, e.energy);
    if (dice.below(8) == 0) e.birthTick = world.globals.tick - dice.below(rules.world.announced_ticks);
    world.add(e);
  }
  for (uint32_t i = 0; i < shots; ++i, id += 1 + dice.below(2)) {
    EntityRecord e = shotAt(rules, id, x(), y(), dice.between(-3.1f, 3.1f), 1 + dice.below(3));
    e.timer = 1 + dice.below(rules.shot.life_ticks);
    if (dice.below(4) == 0) e.target = world.entities.front().id;
    world.add(e);
  }
  for (uint32_t i = 0; i < bits; ++i, id += 1 + dice.below(2)) {
    EntityRecord e = bitAt(rules, id, x(), y());
    e.timer = 1 + dice.below(rules.bit.life_ticks);
    world.add(e);
  }
}

}  // namespace gw::test
