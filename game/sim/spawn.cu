// Spawn: births take the lowest free ids, commands first and in order, then the bits of what died in the
// last tick by parent id. Free ids are ranked by a scan over ids, never over cells, so that the NGrid's
// arrangement has no influence. What died leaves its cell here.
#include "game/sim/behaviour/spawn_patterns.h"
#include "game/sim/entity_access.h"
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kAbreast_m = 0.32f;  // between shots that fly side by side

// Of one id: whether it is free (low half), and how many it gives birth to (high half).
struct CountBirths {
  View v;

  GW_BODY uint64_t operator()(uint32_t id) const {
    const uint32_t type = v.cells[v.cellOf[id]].type;
    uint64_t births = 0;
    if (isEnemy(type)) {
      const Uint4 state = v.state[id];
      const bool scored = (state.w & (kFlagFlushed | kFlagBlasted)) == 0;
      if (state.x == uint32_t(State::dead) && scored) births = v.tables->rules.enemies[type].bits;
    }
    return births << 32 | (type == kTypeNone ? 1u : 0u);
  }
};

// One item: one id, which is freed, filled or left alone. No shot threatens it yet.
struct FillIds {
  View v;

  GW_BODY void operator()(uint32_t id) const {
    const GameGlobals& m = *v.globals;
    v.threat[id] = 0;  // for this tick's shots to raise
    if (m.over) return;
    const TickScratch& s = *v.scratch;
    const uint32_t cell = v.cellOf[id], type = v.cells[cell].type;
    if (id == 0) countRefused();
    if (isEnemy(type) && v.state[id].x == uint32_t(State::dead)) {
      v.cells[cell] = {kInfinity, kInfinity, id, kTypeNone};
      return;
    }
    if (type != kTypeNone) return;
    const uint32_t rank = uint32_t(v.birthScan.before(id));
    if (rank < s.births) {
      const uint32_t command = commandOf(rank);
      const Command& c = s.commands[command];
      if (c.type == kTypeShot) {
        spawnShot(id, cell, c, rank - c.firstBirth);
      } else {
        spawnEnemy(id, cell, c, command, rank - c.firstBirth);
      }
    } else if (rank - s.births < bitBirths()) {
      spawnBit(id, cell, rank - s.births);
    }
  }

 private:
  // Bits that are born: those that fit.
  GW_BODY uint32_t bitBirths() const {
    const uint32_t wanted = uint32_t(v.birthScan.total() >> 32), fits = v.scratch->bitRoom;
    return wanted < fits ? wanted : fits;
  }

  GW_BODY void countRefused() const {
    const uint32_t wanted = uint32_t(v.birthScan.total() >> 32);
    v.globals->refused += wanted - bitBirths();
  }

  GW_BODY uint32_t commandOf(uint32_t birth) const {
    uint32_t command = 0;
    while (command + 1 < v.scratch->commandCount && v.scratch->commands[command + 1].firstBirth <= birth) ++command;
    return command;
  }

  // The parent of own birth k: the last id with at most k births before it.
  GW_BODY uint32_t parentOf(uint32_t k) const {
    uint32_t begin = 0, count = v.capacity;
    while (count > 1) {
      const uint32_t half = count / 2;
      if (uint32_t(v.birthScan.before(begin + half) >> 32) <= k) {
        begin += half;
        count -= half;
      } else {
        count = half;
      }
    }
    return begin;
  }

  // What every newborn has in common: all other fields are 0 until its kind sets them.
  GW_BODY EntityRecord newborn(uint32_t id, uint32_t type, Float2 position, Float2 velocity, Float2 direction) const {
    EntityRecord e{};
    e.id = id;
    e.type = type;
    e.x = e.previous_x = position.x + 0.0f;
    e.y = e.previous_y = position.y + 0.0f;
    e.velocity_x = velocity.x;
    e.velocity_y = velocity.y;
    e.direction_x = direction.x;
    e.direction_y = direction.y;
    e.birthTick = v.globals->tick;
    e.target = kNobody;
    return e;
  }

  GW_BODY void spawnShot(uint32_t id, uint32_t cell, const Command& c, uint32_t k) const {
    const Rules::Shot& shot = v.tables->rules.shot;
    const float middle = float(k) - 0.5f * float(c.count - 1);
    const SineCosine aim = sineCosine(c.angle_rad + middle * c.spread_rad);
    const float abreast = c.spread_rad > 0.0f ? 0.0f : middle * kAbreast_m;
    const Float2 position = {c.x - aim.sine * abreast, c.y + aim.cosine * abreast};
    EntityRecord e = newborn(id, kTypeShot, position, {aim.cosine * shot.speed_mps, aim.sine * shot.speed_mps},
                             {aim.cosine, aim.sine});
    e.energy = shot.damage;
    e.timer = shot.life_ticks;
    e.cooldown = c.hits;
    e.flags = kNobody;
    putEntity(v, cell, e);
  }

  GW_BODY void spawnEnemy(uint32_t id, uint32_t cell, const Command& c, uint32_t command, uint32_t k) const {
    const GameGlobals& m = *v.globals;
    const EnemyRules& rules = v.tables->rules.enemies[c.type];
    const Float2 position = birthPosition(c, k, m.seed, m.tick, command, *v.tables);
    const Float2 toShip = normalised(m.ship.x - position.x, m.ship.y - position.y);
    EntityRecord e = newborn(id, c.type, position, {0.0f, 0.0f}, toShip);
    e.energy = rules.energy;
    e.mass = rules.mass;
    e.state = uint32_t(State::wandering);
    putEntity(v, cell, e);
  }

  GW_BODY void spawnBit(uint32_t id, uint32_t cell, uint32_t k) const {
    const GameGlobals& m = *v.globals;
    const Float4 parent = v.velocityPrevious[parentOf(k)];
    const Uint4 dice = philox(m.seed, {m.tick, k, kPurposeScatter, 0});
    const SineCosine way = sineCosine(unitFloat(dice.x) * kTwoPi);
    const float speed = 2.0f + 4.0f * unitFloat(dice.y);
    EntityRecord e =
        newborn(id, kTypeBit, {parent.z, parent.w}, {way.cosine * speed, way.sine * speed}, {way.cosine, way.sine});
    e.energy = 1.0f;
    e.timer = v.tables->rules.bit.life_ticks;
    putEntity(v, cell, e);
  }
};

}  // namespace

void spawn(Queue& queue, const View& view, Scan& scan) {
  scan.run(queue, CountBirths{view});
  forEach(queue, Count{view.capacity}, FillIds{view});
}

}  // namespace gw::GW_DEVICE
