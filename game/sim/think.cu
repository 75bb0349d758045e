// Think: each enemy runs its state machine and writes its state and steering force; each bit looks for the
// ship. Reads the front of force + energy and direction + mass, writes the back, for every living entity.
#include "game/sim/behaviour_kamikaze.h"
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kBitDrag = 0.94f;  // share of its velocity that a drifting bit keeps per tick

// One item: one cell.
struct Think {
  View v;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.cells[i];
    if (cell.type == kTypeNone) return;
    v.nextForceEnergy[cell.id] = v.forceEnergy[cell.id];
    v.nextDirectionMass[cell.id] = v.directionMass[cell.id];
    if (v.master->over) return;
    v.event[cell.id] = 0;
    if (isEnemy(cell.type)) {
      enemy(cell);
    } else if (cell.type == kTypeBit) {
      bit(cell);
    }
  }

 private:
  GW_BODY void enemy(const Cell& cell) const {
    const Master& m = *v.master;
    const Rules& r = v.tables->rules;
    const EnemyRules& rules = r.enemies[cell.type];
    if (m.tick - v.birthTick[cell.id] < r.world.announced_ticks) return;  // announced: it only stands there

    const Float4 force = v.forceEnergy[cell.id], direction = v.directionMass[cell.id];
    const Float4 motion = v.velocityPrevious[cell.id];
    Uint4 state = v.state[cell.id];
    Self self{cell.id,           cell.type,         cell.x,      cell.y,  motion.x,
              motion.y,          direction.x,       direction.y, force.w, direction.z,
              m.ship.x - cell.x, m.ship.y - cell.y, 0.0f};
    self.shipDistance_m = length(self.ship_x, self.ship_y);

    const State before = State(state.x);
    const uint32_t conditions = kamikazeConditions(self, state.w, rules, r.steering.sightLost);
    const State after = nextState(v.tables->machines[uint32_t(rules.machine)], before, conditions);
    if (after == State::checkingEnergy) state.w &= ~uint32_t(kFlagHit);
    state.x = uint32_t(after);
    v.state[cell.id] = state;
    if (after != before) {
      v.event[cell.id] =
          kEventTransition | uint32_t(before) << kEventFromShift | (after == State::dead ? uint32_t(kEventDied) : 0u);
    }
    if (after == State::dead) return;

    const Wish wish = kamikazeWish(self, after, rules, r.steering, m.seed, m.tick);
    const Float2 steer = steeringForce(self, wish, r.steering.response);
    v.nextForceEnergy[cell.id] = {steer.x, steer.y, 0.0f, force.w};
    v.nextDirectionMass[cell.id] = {wish.direction_x, wish.direction_y, direction.z, 0.0f};
  }

  // A bit near the ship flies to it, and is taken when it arrives.
  GW_BODY void bit(const Cell& cell) const {
    const Master& m = *v.master;
    const Rules::Bit& bit = v.tables->rules.bit;
    const float dx = m.ship.x - cell.x, dy = m.ship.y - cell.y, distance = length(dx, dy);
    Float4 motion = v.velocityPrevious[cell.id];
    if (distance <= bit.take_m) {
      v.event[cell.id] = kEventTaken;
    } else if (distance <= bit.attract_m) {
      motion.x = dx / distance * bit.speed_mps;
      motion.y = dy / distance * bit.speed_mps;
    } else {
      motion.x = motion.x * kBitDrag;
      motion.y = motion.y * kBitDrag;
    }
    v.velocityPrevious[cell.id] = motion;
  }
};

}  // namespace

void think(Queue& queue, const View& view) {
  forEach(queue, Count{view.capacity}, Think{view});
}

}  // namespace gw::GW_DEVICE
