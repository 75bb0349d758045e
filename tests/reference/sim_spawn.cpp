#include <algorithm>
#include <cmath>

#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {
namespace {

constexpr uint32_t kPlacePurpose = 1, kScatterPurpose = 4;
constexpr float kFullTurn = 6.28318530717959f, kFromWall = 1.5f, kSideBySide = 0.32f;

float mirroredIn(float value, float size) {
  const float high = size - kFromWall;
  if (value < kFromWall) value = kFromWall + (kFromWall - value);
  if (value > high) value = high - (value - high);
  return std::clamp(value, kFromWall, high);
}

Float2 wishedPlace(const World& world, const Command& c, uint32_t k, float u, float w) {
  const float n = float(c.count), share = (float(k) + 0.5f) / n;
  const float cos = cpu::cosine(c.angle_rad), sin = cpu::sine(c.angle_rad);
  const auto polar = [&](float angle, float radius) {
    return Float2{c.x + cpu::cosine(angle) * radius, c.y + cpu::sine(angle) * radius};
  };
  switch (c.pattern) {
    case Pattern::ring:
      return polar(c.angle_rad + share * kFullTurn, 20.0f + 6.0f * u);
    case Pattern::spiral:
      return polar(c.angle_rad + share * 3.0f * kFullTurn, 16.0f + 16.0f * share);
    case Pattern::cluster: {
      const float far = 24.0f + 16.0f * (sin * sin), r = 0.75f * std::sqrt(n) * std::sqrt(u), a = w * kFullTurn;
      return {c.x + cos * far + cpu::cosine(a) * r, c.y + sin * far + cpu::sine(a) * r};
    }
    case Pattern::corners: {
      const float spread = 2.0f + 0.5f * std::sqrt(n);
      return {c.x + (k % 2 ? 30.0f : -30.0f) + (2.0f * u - 1.0f) * spread,
              c.y + (k / 2 % 2 ? 18.0f : -18.0f) + (2.0f * w - 1.0f) * spread};
    }
    case Pattern::wall: {
      const float gapAt = 0.25f + 0.38f * (cos * cos), along = share * 0.88f;
      const float offset = ((along > gapAt ? along + 0.12f : along) - 0.5f) * 64.0f, far = 24.0f + 10.0f * u;
      return {c.x + cos * far - sin * offset, c.y + sin * far + cos * offset};
    }
    case Pattern::rain:
      return {u * world.limits.width_m, w * world.limits.height_m};
    default: {
      const float beside = (sin < 0.0f ? -28.0f : 28.0f) + (w - 0.5f) * 24.0f;
      return cos * cos < 0.5f ? Float2{c.x + beside, u * world.limits.height_m}
                              : Float2{u * world.limits.width_m, c.y + beside};
    }
  }
}

EntityRecord blank(const World& world, uint32_t type, Float2 place, Float2 velocity, Float2 direction) {
  EntityRecord e{};
  e.type = type;
  e.x = e.previous_x = place.x;
  e.y = e.previous_y = place.y;
  e.velocity_x = velocity.x;
  e.velocity_y = velocity.y;
  e.direction_x = direction.x;
  e.direction_y = direction.y;
  e.birthTick = world.globals.tick;
  e.target = kNobody;
  return e;
}

EntityRecord shot(const World& world, const Command& c, uint32_t k) {
  const Rules::Shot& rules = world.rules.shot;
  const float middle = float(k) - 0.5f * float(c.count - 1), angle = c.angle_rad + middle * c.spread_rad;
  const float cos = cpu::cosine(angle), sin = cpu::sine(angle);
  const float aside = c.spread_rad > 0.0f ? 0.0f : middle * kSideBySide;
  EntityRecord e = blank(world, kTypeShot, {c.x - sin * aside, c.y + cos * aside},
                         {cos * rules.speed_mps, sin * rules.speed_mps}, {cos, sin});
  e.energy = rules.damage;
  e.timer = rules.life_ticks;
  e.cooldown = c.hits;
  e.flags = kNobody;
  return e;
}

EntityRecord enemy(const World& world, const Command& c, uint32_t index, uint32_t k) {
  const Float2 place = birthPlace(world, c, index, k);
  const float x = world.globals.ship.x - place.x, y = world.globals.ship.y - place.y, far = std::sqrt(x * x + y * y);
  EntityRecord e = blank(world, c.type, place, {0, 0}, {x / far, y / far});
  e.energy = world.rules.enemies[c.type].energy;
  e.mass = world.rules.enemies[c.type].mass;
  return e;
}

EntityRecord bit(const World& world, const Entity& parent, uint32_t k) {
  const auto dice = cpu::philox(world.globals.seed, {world.globals.tick, k, kScatterPurpose, 0});
  const float angle = cpu::unitFloat(dice.x) * kFullTurn, speed = 2.0f + 4.0f * cpu::unitFloat(dice.y);
  const float cos = cpu::cosine(angle), sin = cpu::sine(angle);
  EntityRecord e = blank(world, kTypeBit, {parent.x, parent.y}, {cos * speed, sin * speed}, {cos, sin});
  e.energy = 1.0f;
  e.timer = world.rules.bit.life_ticks;
  return e;
}

}  // namespace

Float2 birthPlace(const World& world, const Command& c, uint32_t index, uint32_t k) {
  const float width = world.limits.width_m, height = world.limits.height_m;
  const float clear = world.mode == Mode::swarm ? world.rules.swarm.clearance_m : world.rules.world.spawnClearance_m;
  const auto near = [&](Float2 p) { return std::sqrt((p.x - c.x) * (p.x - c.x) + (p.y - c.y) * (p.y - c.y)) < clear; };
  Float2 place{};
  for (uint32_t attempt = 0; attempt < (c.pattern == Pattern::rain ? 16u : 1u); ++attempt) {
    const auto dice = cpu::philox(world.globals.seed, {world.globals.tick, index + 65536 * attempt, kPlacePurpose, k});
    const Float2 wish = wishedPlace(world, c, k, cpu::unitFloat(dice.x), cpu::unitFloat(dice.y));
    place = {mirroredIn(wish.x, width), mirroredIn(wish.y, height)};
    if (!near(place)) return place;
  }
  if (near(place)) place = {width - place.x, height - place.y};
  if (near(place)) {  // towards the far walls, where there is room
    place.x = mirroredIn(c.x > 0.5f * width ? c.x - clear : c.x + clear, width);
    place.y = mirroredIn(c.y > 0.5f * height ? c.y - clear : c.y + clear, height);
  }
  return place;
}

void spawn(World& world) {
  std::vector<uint32_t> freeIds;
  for (uint32_t id = 0; id < world.limits.capacity; ++id) {
    const bool taken =
        std::any_of(world.entities.begin(), world.entities.end(), [&](const Entity& e) { return e.id == id; });
    if (!taken) freeIds.push_back(id);
  }
  std::vector<EntityRecord> births;
  for (uint32_t index = 0; index < world.commands.size(); ++index) {
    const Command& c = world.commands[index];
    for (uint32_t k = 0; k < c.count; ++k) {
      births.push_back(c.type == kTypeShot ? shot(world, c, k) : enemy(world, c, index, k));
    }
  }
  // A bit's place is counted before the ones that ran out of time leave, as the last tick's totals did.
  uint32_t bits = 0, born = 0;
  for (const Entity& e : world.entities) bits += e.type == kTypeBit;
  for (const Entity& e : world.entities) {
    if (!world.isEnemy(e) || e.state != uint32_t(Mind::dead) || (e.flags & (kFlagFlushed | kFlagBlasted))) continue;
    for (uint32_t b = 0; b < world.rulesOf(e).bits; ++b) {
      if (bits + born < kBitCapacity) {
        births.push_back(bit(world, e, born++));
      } else {
        ++world.globals.refused;
      }
    }
  }
  std::erase_if(world.entities, [&](const Entity& e) { return world.isEnemy(e) && e.state == uint32_t(Mind::dead); });
  for (size_t i = 0; i < births.size() && i < freeIds.size(); ++i) {
    births[i].id = freeIds[i];
    world.add(births[i]);
  }
}

}  // namespace gw::naive
