// Integrate: Euler steps. Velocity from force and mass, position from velocity; the world's bounds; the
// previous position is kept. Reads `cells`, writes `moved` for every cell, the dead ones too.
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one cell.
struct Integrate {
  View v;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.cells[i];
    if (v.globals->over || cell.type == kTypeNone) {
      v.moved[i] = cell;
    } else if (isEnemy(cell.type)) {
      enemy(i, cell);
    } else {
      projectile(i, cell);
    }
  }

 private:
  GW_BODY void enemy(uint32_t i, const Cell& cell) const {
    const Limits& limits = v.tables->limits;
    const EnemyRules& rules = v.tables->rules.enemies[cell.type];
    Float4 motion = v.velocityPrevious[cell.id];
    motion.z = cell.x;
    motion.w = cell.y;
    if (v.state[cell.id].x == uint32_t(State::dead)) {  // stays where it died until spawn frees its id
      v.velocityPrevious[cell.id] = {0.0f, 0.0f, cell.x, cell.y};
      v.moved[i] = cell;
      return;
    }
    const Float4 force = v.nextForceEnergy[cell.id];
    Float4 direction = v.nextDirectionMass[cell.id];
    motion.x += force.x / direction.z * kTick_s;
    motion.y += force.y / direction.z * kTick_s;
    const Float2 push = v.push[cell.id];
    float step_x = motion.x + push.x, step_y = motion.y + push.y;
    const float speed = length(step_x, step_y), fastest = limits.fastestEnemy_mps;
    if (speed > fastest) {
      step_x = step_x * (fastest / speed);
      step_y = step_y * (fastest / speed);
    }
    float x = cell.x + step_x * kTick_s, y = cell.y + step_y * kTick_s;
    reflect(x, motion.x, direction.x, rules.halfWidth_m, limits.width_m - rules.halfWidth_m);
    reflect(y, motion.y, direction.y, rules.halfHeight_m, limits.height_m - rules.halfHeight_m);
    v.velocityPrevious[cell.id] = motion;
    v.nextDirectionMass[cell.id] = direction;
    v.moved[i] = {x + 0.0f, y + 0.0f, cell.id, cell.type};
    // Squared steps are not negative, so their bits are ordered as they are.
    const float dx = x - cell.x, dy = y - cell.y;
    atomicRaiseTo(v.scratch->longestStep2, bitsOf(dx * dx + dy * dy));
  }

  // Walls reflect an enemy; it never leaves the world.
  GW_BODY static void reflect(float& position, float& velocity, float& direction, float low, float high) {
    if (position < low) {
      position = low;
      velocity = magnitude(velocity);
      direction = magnitude(direction);
    } else if (position > high) {
      position = high;
      velocity = -magnitude(velocity);
      direction = -magnitude(direction);
    }
  }

  // Shots and bits: they live for so many ticks; a shot ends at the walls, a bit stays inside them.
  GW_BODY void projectile(uint32_t i, const Cell& cell) const {
    const Limits& limits = v.tables->limits;
    Float4 motion = v.velocityPrevious[cell.id];
    Uint4 state = v.state[cell.id];
    state.y = state.y > 0 ? state.y - 1 : 0;
    float x = cell.x + motion.x * kTick_s, y = cell.y + motion.y * kTick_s;
    const bool outside = x < 0.0f || x > limits.width_m || y < 0.0f || y > limits.height_m;
    const bool gone = state.y == 0 || (cell.type == kTypeShot ? outside : (v.event[cell.id] & kEventTaken) != 0);
    if (cell.type == kTypeBit) {
      x = clamp(x, 0.0f, limits.width_m);
      y = clamp(y, 0.0f, limits.height_m);
    }
    v.velocityPrevious[cell.id] = {motion.x, motion.y, cell.x, cell.y};
    v.state[cell.id] = state;
    v.moved[i] = gone ? Cell{kInfinity, kInfinity, cell.id, kTypeNone} : Cell{x + 0.0f, y + 0.0f, cell.id, cell.type};
  }
};

}  // namespace

void integrate(Queue& queue, const View& view) {
  forEach(queue, Count{view.capacity}, Integrate{view});
}

}  // namespace gw::GW_DEVICE
