#include <algorithm>
#include <cmath>

#include "gpu/math/exact_math.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {
namespace {

void turnAtWalls(float& place, float& velocity, float& direction, float half, float size) {
  if (place < half) {
    place = half;
    velocity = std::fabs(velocity);
    direction = std::fabs(direction);
  }
  if (place > size - half) {
    place = size - half;
    velocity = -std::fabs(velocity);
    direction = -std::fabs(direction);
  }
}

void moveEnemy(const World& world, Entity& e) {
  e.previous_x = e.x;
  e.previous_y = e.y;
  if (e.state == uint32_t(Mind::dead)) {
    e.velocity_x = e.velocity_y = 0.0f;
    return;
  }
  e.velocity_x += e.force_x / e.mass * kTick_s;
  e.velocity_y += e.force_y / e.mass * kTick_s;
  float speed_x = e.velocity_x + e.push_x, speed_y = e.velocity_y + e.push_y;
  const float speed = std::sqrt(speed_x * speed_x + speed_y * speed_y), most = world.limits.fastestEnemy_mps;
  if (speed > most) {
    speed_x *= most / speed;
    speed_y *= most / speed;
  }
  e.x += speed_x * kTick_s;
  e.y += speed_y * kTick_s;
  const EnemyRules& body = world.rulesOf(e);
  turnAtWalls(e.x, e.velocity_x, e.direction_x, body.halfWidth_m, world.limits.width_m);
  turnAtWalls(e.y, e.velocity_y, e.direction_y, body.halfHeight_m, world.limits.height_m);
}

void moveOther(const World& world, Entity& e) {
  e.previous_x = e.x;
  e.previous_y = e.y;
  if (e.timer > 0) --e.timer;
  e.x += e.velocity_x * kTick_s;
  e.y += e.velocity_y * kTick_s;
  if (e.timer == 0) e.gone = true;
  if (e.type == kTypeBit) {
    if (e.taken) e.gone = true;
    e.x = std::clamp(e.x, 0.0f, world.limits.width_m);
    e.y = std::clamp(e.y, 0.0f, world.limits.height_m);
  } else if (!(e.x >= 0.0f && e.x <= world.limits.width_m && e.y >= 0.0f && e.y <= world.limits.height_m)) {
    e.gone = true;
  }
}

}  // namespace

Entity& World::add(const EntityRecord& record) {
  const auto later = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id > record.id; });
  return *entities.insert(later, Entity{record});
}

Entity& World::byId(uint32_t id) {
  return *std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == id; });
}

std::vector<EntityRecord> World::records() const {
  return {entities.begin(), entities.end()};
}

void integrate(World& world) {
  for (Entity& e : world.entities) {
    if (world.isEnemy(e)) {
      moveEnemy(world, e);
    } else {
      moveOther(world, e);
    }
  }
}

void tick(World& world, const InputRecord& input) {
  world.input = input;
  if (world.globals.over) return;
  logic(world);
  if (world.globals.over) return;
  spawn(world);
  think(world);
  integrate(world);
  collide(world);
  settle(world);
}

}  // namespace gw::naive
