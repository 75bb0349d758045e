// Collide: the narrow phase, swept over the motion of this tick, in passes.
//
//   choose   each shot picks the victim it meets first (ties: the lowest id)
//   resolve  each enemy takes the shots that picked it in (time, id) order until its energy is gone; the
//            ship's contact, its blast and the flush; knock-back
//   push     overlapping enemies are pushed apart, each pair once; then each responds to its sum
//   finish   each shot that picked a victim stays at the point of contact for this tick, spent or flying on:
//            so it cannot skip a second victim behind the first
//
// Gathers search `cells` (the start of the tick, sorted), with radii widened by what a tick can move. An inexact
// gather misses some and need not be symmetric: a shot that its victim does not find flies on unhindered.
#include "game/sim/contact/overlap.h"
#include "game/sim/contact/pushes.h"
#include "game/sim/contact/sweep.h"
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {
namespace {

// Gathers compare rounded distances: a margin far above a rounding error, far below anything visible.
constexpr float kMargin_m = 0.01f;

GW_FN bool canBeHit(const View& v, uint32_t id) {
  return v.nextForceEnergy[id].w > 0.0f && v.state[id].x != uint32_t(State::dead) && !isAnnounced(v, id);
}

// The farthest that any enemy moved in this tick.
GW_FN float enemyStep_m(const View& v) {
  return sqrtf(floatOf(uint32_t(v.scratch->longestStep2))) + kMargin_m;
}

// Where a shot ends this tick when it hits nothing. Not from `moved`: integrate has removed the shots that leave the
// world or expire now, and what is on their last path is hit all the same.
GW_FN Float2 endOfShot(const View& v, const Cell& from) {
  const Float4 motion = v.velocityPrevious[from.id];
  return {from.x + motion.x * kTick_s, from.y + motion.y * kTick_s};
}

// One item: one id. No victim is picked and no push added yet.
struct ClearChoices {
  View v;
  GW_BODY void operator()(uint32_t id) const {
    v.choice[id] = kNobody;
    v.choiceTime[id] = 0.0f;
    v.chosenBy[id] = 0;
    v.spent[id] = 0;
    v.pushSum[3 * id] = v.pushSum[3 * id + 1] = v.pushSum[3 * id + 2] = 0;
  }
};

// One item: one cell; works for shots.
template <class Search>
struct ChooseVictims {
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell from = v.cells[i];
    if (from.type != kTypeShot || v.globals->over) return;
    const Float2 to = endOfShot(v, from);
    const Rules& r = v.tables->rules;
    const float dx = to.x - from.x, dy = to.y - from.y;
    const uint32_t last = v.target[from.id], victimBeforeLast = v.state[from.id].w;
    const float reach = length(dx, dy) + r.shot.radius_m + v.tables->limits.largestReach_m + enemyStep_m(v) + kMargin_m;
    float first = kNoContact;
    uint32_t victim = kNobody;
    search.around(i, placeOf(from), reach, [&](const Cell& other, uint32_t otherCell, Float2) {
      if (!isEnemy(other.type) || other.id == last || other.id == victimBeforeLast) return;
      const Cell end = v.moved[otherCell];
      const float t = sweepBody(from.x - other.x, from.y - other.y, dx - (end.x - other.x), dy - (end.y - other.y),
                                r.shot.radius_m, r.enemies[other.type]);
      if (t > first || t > 1.0f || (t == first && other.id > victim) || !canBeHit(v, other.id)) return;
      first = t;
      victim = other.id;
    });
    if (victim == kNobody) return;
    v.choice[from.id] = victim;
    v.choiceTime[from.id] = first;
    atomicAddTo(v.chosenBy[victim], 1);
  }
};

// One item: one cell; works for enemies.
template <class Search>
struct ResolveHits {
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell from = v.cells[i];
    if (!isEnemy(from.type) || v.globals->over) return;
    if (v.state[from.id].x == uint32_t(State::dead)) return;
    const Cell to = v.moved[i];
    if (v.chosenBy[from.id] > 0) takeHits(i, from);
    if (!isAnnounced(v, from.id)) resolveShipContact(from, to);
  }

 private:
  // The order of two shots at one victim.
  GW_BODY static uint64_t hitOrder(float time, uint32_t id) { return uint64_t(bitsOf(time)) << 32 | id; }

  GW_BODY void takeHits(uint32_t i, const Cell& self) const {
    const Rules& r = v.tables->rules;
    Float4 force = v.nextForceEnergy[self.id];
    Float4 motion = v.velocityPrevious[self.id];
    const float reach = r.shot.speed_mps * kTick_s + r.shot.radius_m + v.tables->limits.largestReach_m +
                        enemyStep_m(v) + 2.0f * kMargin_m;
    uint64_t done = 0;  // order of the last shot taken, plus one
    for (uint32_t taken = 0; taken < v.chosenBy[self.id] && force.w > 0.0f; ++taken) {
      uint64_t next = ~0ull;
      uint32_t cellOfNext = 0;
      search.around(i, placeOf(self), reach, [&](const Cell& shot, uint32_t shotCell, Float2) {
        if (shot.type != kTypeShot || v.choice[shot.id] != self.id) return;
        const uint64_t order = hitOrder(v.choiceTime[shot.id], shot.id);
        if (order < done || order >= next) return;
        next = order;
        cellOfNext = shotCell;
      });
      if (next == ~0ull) break;
      const uint32_t shot = v.cells[cellOfNext].id;
      v.spent[shot] = 1;
      force.w -= v.nextForceEnergy[shot].w;
      const Float4 direction = v.nextDirectionMass[shot];
      const float knockBack_mps = r.shot.knockBack_mps / v.nextDirectionMass[self.id].z;
      motion.x += direction.x * knockBack_mps;
      motion.y += direction.y * knockBack_mps;
      done = next + 1;
    }
    if (done == 0) return;  // its gather found none of them
    v.nextForceEnergy[self.id] = force;
    v.velocityPrevious[self.id] = motion;
    v.state[self.id].w |= kFlagHit;
  }

  // Contact costs the ship time; its blast and the flush end what they reach.
  GW_BODY void resolveShipContact(const Cell& from, const Cell& to) const {
    const GameGlobals& m = *v.globals;
    const Rules& r = v.tables->rules;
    const EnemyRules& rules = r.enemies[from.type];
    const Ship& ship = m.ship;
    Float4 force = v.nextForceEnergy[from.id];
    if (force.w <= 0.0f) return;
    const float distance = length(to.x - ship.x, to.y - ship.y);
    const bool weak = rules.energy <= r.ship.weakEnergy;
    uint32_t fate = 0;
    if (m.blast != kBlastNone && (from.id == m.blastId || (weak && distance <= r.ship.blast_m))) fate = kFlagBlasted;
    if (m.blast == kBlastAll) fate = kFlagBlasted;
    if (fate == 0 && m.flushRadius_m > 0.0f &&
        length(to.x - m.flush_x, to.y - m.flush_y) <= m.flushRadius_m + rules.halfWidth_m) {
      fate = kFlagFlushed;
    }
    if (fate != 0) {
      force.w = 0.0f;
      v.nextForceEnergy[from.id] = force;
      v.state[from.id].w |= kFlagHit | fate;
      return;
    }
    if (ship.untouchable_ticks > 0) return;
    const float near = reachOf(rules) + r.ship.radius_m + enemyStep_m(v) + r.ship.speed_mps * kTick_s + kMargin_m;
    if (distance > near) return;  // nearly all: no sweep is needed
    const float t =
        sweepBody(ship.previous_x - from.x, ship.previous_y - from.y, (ship.x - ship.previous_x) - (to.x - from.x),
                  (ship.y - ship.previous_y) - (to.y - from.y), r.ship.radius_m, rules);
    if (t <= 1.0f)
      atomicRaiseTo(v.globals->totals.contact, uint64_t(rules.contact_us) << 32 | (~from.id & 0xFFFFFFFFu));
  }
};

// One item: one cell; works for enemies. Overlapping bodies are pushed apart: each pair shares its penetration by
// mass, half of it per tick. A pair is found once, from the cell that comes first, and pushes both ways: sums of
// integers do not depend on the order.
template <class Search>
struct PushApart {
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell from = v.cells[i];
    if (!isEnemy(from.type) || v.globals->over || v.state[from.id].x == uint32_t(State::dead)) return;
    const Cell to = v.moved[i];
    const Rules& r = v.tables->rules;
    const EnemyRules& own = r.enemies[from.type];
    const float mass = v.nextDirectionMass[from.id].z;
    // From its position after this tick to those of the others before it.
    const float step = enemyStep_m(v), reach = reachOf(own) + v.tables->limits.largestReach_m + step;
    const float near_x = own.halfWidth_m + step, near_y = own.halfHeight_m + step;
    Pushes sum;
    search.after(i, {to.x, to.y}, reach, [&](const Cell& other, uint32_t otherCell, Float2 offset) {
      if (!isEnemy(other.type)) return;
      const EnemyRules& theirs = r.enemies[other.type];
      // Most are out of reach even by their boxes, and need not be looked up.
      if (magnitude(offset.x) > near_x + theirs.halfWidth_m || magnitude(offset.y) > near_y + theirs.halfHeight_m)
        return;
      const Cell end = v.moved[otherCell];
      const Float2 penetration = overlap(own, theirs, to.x - end.x, to.y - end.y, from.id < other.id ? 1.0f : -1.0f);
      if (penetration.x == 0.0f && penetration.y == 0.0f) return;
      if (v.state[other.id].x == uint32_t(State::dead)) return;
      constexpr float kPerTick = 0.5f * float(kTicksPerSecond);
      const float otherMass = v.nextDirectionMass[other.id].z, masses = mass + otherMass;
      const float share = otherMass / masses * kPerTick, theirShare = mass / masses * kPerTick;
      sum.add(penetration.x * share, penetration.y * share);
      Pushes back;
      back.add(-penetration.x * theirShare, -penetration.y * theirShare);
      addTo(other.id, back);
    });
    addTo(from.id, sum);
  }

 private:
  GW_BODY void addTo(uint32_t id, const Pushes& pushes) const {
    if (pushes.lengths == 0) return;
    atomicAddTo64(v.pushSum[3 * id], uint64_t(pushes.sum.x));
    atomicAddTo64(v.pushSum[3 * id + 1], uint64_t(pushes.sum.y));
    atomicAddTo64(v.pushSum[3 * id + 2], uint64_t(pushes.lengths));
  }
};

// One item: one cell; works for enemies.
struct RespondToPushes {
  View v;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.cells[i];
    if (!isEnemy(cell.type) || v.globals->over || v.state[cell.id].x == uint32_t(State::dead)) return;
    const uint64_t* sums = v.pushSum + 3 * size_t(cell.id);
    const Pushes pushes{{int64_t(sums[0]), int64_t(sums[1])}, int64_t(sums[2])};
    if (pushes.lengths == 0) {
      v.push[cell.id] = {0.0f, 0.0f};
      return;
    }
    Float2 push = pushes.sum.total(kPushScale);
    const float speed = length(push.x, push.y), most = v.tables->rules.steering.separation_mps;
    if (speed > most) push = {push.x * (most / speed), push.y * (most / speed)};
    respond(cell.id, push, pushes.pressed_mps());
  }

 private:
  // Moves by the push in the next tick; a body that moves against it loses that part of its velocity, the more the
  // stronger the push; and one that is pressed from all sides is slowed. Without these a crowd contracts to a point
  // faster than pushes can separate it.
  GW_BODY void respond(uint32_t id, Float2 push, float pressed_mps) const {
    const Rules::Steering& steering = v.tables->rules.steering;
    v.push[id] = push;
    Float4 motion = v.velocityPrevious[id];
    const float speed = length(push.x, push.y);
    if (speed > 0.0f) {
      const float against = (motion.x * push.x + motion.y * push.y) / speed;
      if (against < 0.0f) {
        const float lost = against * (speed / steering.separation_mps) / speed;
        motion.x -= push.x * lost;
        motion.y -= push.y * lost;
      }
    }
    const float kept = steering.press_mps / (steering.press_mps + pressed_mps);
    motion.x = motion.x * kept;
    motion.y = motion.y * kept;
    v.velocityPrevious[id] = motion;
  }
};

// One item: one cell; works for shots.
struct FinishShots {
  View v;

  GW_BODY void operator()(uint32_t i) const {
    const Cell from = v.cells[i];
    if (from.type != kTypeShot || v.globals->over) return;
    const uint32_t victim = v.choice[from.id];
    if (victim == kNobody) return;
    // Alive and yet not hit by it: the victim's gather missed it. In an exact game other shots would have killed it.
    if (!v.spent[from.id] && canBeHit(v, victim)) return;
    const Float2 to = endOfShot(v, from);
    const float t = v.choiceTime[from.id];
    Cell end = {from.x + (to.x - from.x) * t + 0.0f, from.y + (to.y - from.y) * t + 0.0f, from.id, from.type};
    Uint4 state = v.state[from.id];
    if (v.spent[from.id]) {
      state.z -= 1;
      state.w = v.target[from.id];
      v.state[from.id] = state;
      v.target[from.id] = victim;
    }
    if (state.y == 0 || state.z == 0) end = {kInfinity, kInfinity, from.id, kTypeNone};
    v.moved[i] = end;
  }
};

// One item: one cell. The two concern different kinds of entities and depend on the same passes.
struct RespondAndFinishShots {
  View v;
  GW_BODY void operator()(uint32_t i) const {
    RespondToPushes{v}(i);
    FinishShots{v}(i);
  }
};

}  // namespace

void collide(Queue& queue, const View& view) {
  const Count all{view.capacity};
  forEach(queue, all, ClearChoices{view});
  withSearch(view.near, [&](auto search) {
    forEach(queue, all, ChooseVictims<decltype(search)>{view, search});
    forEach(queue, all, ResolveHits<decltype(search)>{view, search});
    forEach(queue, all, PushApart<decltype(search)>{view, search});
  });
  forEach(queue, all, RespondAndFinishShots{view});
}

}  // namespace gw::GW_DEVICE
