// Think: each enemy runs its state machine and writes its state and steering force; each bit looks for the
// ship. Reads the front of force + energy and direction + mass, writes the back, for every living entity.
//
// In two passes: the few shots mark themselves as threats to the many enemies ahead of them; then think.
#include "game/sim/behaviour/behaviour_group.h"
#include "game/sim/behaviour/behaviour_kamikaze.h"
#include "game/sim/behaviour/behaviour_tricky.h"
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kBitDrag = 0.94f;  // share of its velocity that a drifting bit keeps per tick

// One item: one cell; works for shots. Each enemy keeps the nearest shot that would hit or graze it.
template <class Search>
struct MarkThreats {
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell shot = v.cells[i];
    if (shot.type != kTypeShot || v.globals->over) return;
    const Rules& r = v.tables->rules;
    const Float4 direction = v.directionMass[shot.id];
    search.around(i, placeOf(shot), r.steering.threat_m, [&](const Cell& other, uint32_t, Float2 offset) {
      if (!isEnemy(other.type) || !isOneOf(r.enemies[other.type].machine, kDodgingMachines)) return;
      if (direction.x * offset.x + direction.y * offset.y <= 0.0f) return;  // behind it
      const float across = magnitude(direction.x * offset.y - direction.y * offset.x);
      if (across > reachOf(r.enemies[other.type]) + r.steering.threatMargin_m) return;
      // Squared distances are not negative, so their bits are ordered as they are.
      const uint64_t nearness = uint64_t(bitsOf(offset.x * offset.x + offset.y * offset.y)) << 32 | shot.id;
      atomicRaiseTo(v.threat[other.id], ~nearness);
    });
  }
};

// One item: one cell.
template <class Search>
struct Think {
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.cells[i];
    if (cell.type == kTypeNone) return;
    v.nextForceEnergy[cell.id] = v.forceEnergy[cell.id];
    v.nextDirectionMass[cell.id] = v.directionMass[cell.id];
    if (v.globals->over) return;
    v.event[cell.id] = 0;
    if (isEnemy(cell.type)) {
      enemy(i, cell);
    } else if (cell.type == kTypeBit) {
      bit(cell);
    }
  }

 private:
  GW_BODY void enemy(uint32_t i, const Cell& cell) const {
    const GameGlobals& m = *v.globals;
    const Rules& r = v.tables->rules;
    const EnemyRules& rules = r.enemies[cell.type];
    const uint64_t threat = v.threat[cell.id];
    if (isAnnounced(v, cell.id)) return;  // it does not move yet

    const Float4 force = v.forceEnergy[cell.id], direction = v.directionMass[cell.id];
    const Float4 motion = v.velocityPrevious[cell.id];
    Uint4 state = v.state[cell.id];
    Self self{cell.id,     cell.type,   cell.x,  cell.y,      motion.x,          motion.y,
              direction.x, direction.y, force.w, direction.z, m.ship.x - cell.x, m.ship.y - cell.y};
    self.shipDistance_m = length(self.ship_x, self.ship_y);
    self.speed_mps = rules.speed_mps * m.pace;

    const State before = State(state.x);
    if (before == State::avoiding && state.y > 0) --state.y;
    if (state.z > 0) --state.z;
    uint32_t conditions = conditionsOf(self, state, rules, threat);
    // Its own kind is gathered every kAskEvery_ticks, staggered by id, because gathers are most of the cost of a horde.
    // An enemy that has just lost the ship gathers at once.
    const bool due = (m.tick + cell.id) % kAskEvery_ticks == 0;
    const bool looks = isOneOf(rules.machine, kFlockingMachines) && (kLooksAround >> uint32_t(before) & 1u) != 0;
    Flock flock;
    if (looks && before == State::attacking && !(conditions & kLostShip)) {
      // An enemy that sees the ship needs at most its group's heading. In between, its own heading, which follows the
      // group's, stands for it.
      if (!due) flock.heading.add(direction.x, direction.y, kSteerScale);
      if (due && rules.machine == Machine::group) gatherHeadings(i, cell, rules.vision_m, flock);
    } else if (looks && (due || before == State::attacking)) {
      gatherFlock(i, cell, rules.vision_m, flock);
      conditions |= flock.count > 0 ? kOwnKind : kAlone;
    }
    const State after = nextState(v.tables->machines[uint32_t(rules.machine)], before, conditions);
    if (after == State::checkingEnergy) state.w &= ~uint32_t(kFlagHit);
    if (after == State::avoiding && before != State::avoiding) {
      state.y = r.steering.avoid_ticks;
      state.z = rules.avoidCooldown_ticks;
      const uint32_t shot = ~uint32_t(threat);
      const Cell from = v.cells[v.cellOf[shot]];
      const Float4 shotDirection = v.directionMass[shot];
      const Float2 away = awayFromPath({shotDirection.x, shotDirection.y}, {cell.x - from.x, cell.y - from.y}, cell.id);
      self.direction_x = away.x;
      self.direction_y = away.y;
    }
    state.x = uint32_t(after);
    v.state[cell.id] = state;
    if (after != before) {
      const uint32_t died = after == State::dead ? uint32_t(kEventDied) : 0u;
      v.event[cell.id] = kEventTransition | died | uint32_t(before) << kEventFromShift;
    }
    if (after == State::dead) return;

    const DesiredMotion desired = desiredMotionOf(self, after, flock, rules);
    const float response = after == State::avoiding ? r.steering.avoidResponse : r.steering.response;
    const Float2 steer = steeringForce(self, desired, response);
    float energy = force.w;
    if (after == State::escaping) energy = smaller(energy + r.steering.recover_per_s * kTick_s, rules.energy);
    v.nextForceEnergy[cell.id] = {steer.x, steer.y, 0.0f, energy};
    v.nextDirectionMass[cell.id] = {desired.direction_x, desired.direction_y, direction.z, 0.0f};
  }

  // Entities that died left their cells in this tick's spawn: all that are found are alive.
  GW_BODY void gatherFlock(uint32_t i, const Cell& cell, float vision_m, Flock& flock) const {
    search.around(i, placeOf(cell), vision_m, [&](const Cell& other, uint32_t, Float2 away) {
      if (other.type != cell.type || other.id == cell.id) return;
      const Float4 otherDirection = v.directionMass[other.id];
      flock.add(away.x, away.y, otherDirection.x, otherDirection.y);
    });
  }

  // Their heading only.
  GW_BODY void gatherHeadings(uint32_t i, const Cell& cell, float vision_m, Flock& flock) const {
    search.around(i, placeOf(cell), vision_m, [&](const Cell& other, uint32_t, Float2) {
      if (other.type != cell.type || other.id == cell.id) return;
      const Float4 otherDirection = v.directionMass[other.id];
      flock.heading.add(otherDirection.x, otherDirection.y, kSteerScale);
    });
  }

  GW_BODY uint32_t conditionsOf(const Self& self, const Uint4& state, const EnemyRules& rules, uint64_t threat) const {
    const Rules::Steering& steering = v.tables->rules.steering;
    const bool all = v.globals->allAttack != 0;
    uint32_t conditions = 0;
    if (state.w & kFlagHit) conditions |= kDamaged;
    if (self.energy <= 0.0f) conditions |= kEnergyGone;
    if (self.energy < rules.energy * steering.escapeBelow) conditions |= kEnergyLow;
    if (self.energy >= rules.energy * steering.recoveredAt) conditions |= kRecovered;
    if (state.y == 0) conditions |= kAvoided;
    if (threat != 0 && state.z == 0) conditions |= kShotComing;
    if (all || self.shipDistance_m <= rules.sight_m) conditions |= kSeesShip;
    if (!all && self.shipDistance_m > rules.sight_m * steering.sightLost) conditions |= kLostShip;
    return conditions;
  }

  GW_BODY DesiredMotion desiredMotionOf(const Self& self, State state, const Flock& flock,
                                        const EnemyRules& rules) const {
    const GameGlobals& m = *v.globals;
    const Rules::Steering& steering = v.tables->rules.steering;
    switch (state) {
      case State::attacking:
        return attack(self, flock, rules);
      case State::grouping:
        return flock.count > 0 ? flyInFlock(self, flock, steering, m.seed, m.tick) : keepHeading(self, steering);
      case State::avoiding:
        return avoid(self, steering);
      case State::escaping:
        return escape(self, steering, v.tables->limits);
      case State::checkingEnergy:
        return coast(self);
      default:
        return wander(self, steering, m.seed, m.tick);
    }
  }

  GW_BODY DesiredMotion attack(const Self& self, const Flock& flock, const EnemyRules& rules) const {
    const Rules::Steering& steering = v.tables->rules.steering;
    switch (rules.machine) {
      case Machine::group:
        return groupAttack(self, flock, steering);
      case Machine::tricky:
        return trickyAttack(self, steering);
      default:
        return kamikazeAttack(self, rules, steering);
    }
  }

  // A bit near the ship flies to it, and is taken when it arrives.
  GW_BODY void bit(const Cell& cell) const {
    const GameGlobals& m = *v.globals;
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
  const Count all{view.capacity};
  withSearch(view.near, [&](auto search) {
    forEach(queue, all, MarkThreats<decltype(search)>{view, search});
    forEach(queue, all, Think<decltype(search)>{view, search});
  });
}

}  // namespace gw::GW_DEVICE
