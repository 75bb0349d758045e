#include <cmath>

#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/fixed_sum.h"
#include "gpu/math/philox.h"
#include "tests/reference/sim_world.h"

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

// What an enemy finds out by looking at all entities as they were at the start of the tick.
struct Sight {
  uint32_t kin = 0;
  Vector middle{0, 0}, heading{0, 0};  // of its kin, unit vectors
  const Entity* shot = nullptr;        // the nearest that would hit or graze it
};

// Sums in the same fixed point as the game: float sums would depend on the order.
Vector unitOf(const cpu::FixedSum2& sum) {
  const Float2 total = sum.total(1048576.0f);
  return unit(total.x, total.y);
}

Vector unitOfOwn(const Entity& e) {
  cpu::FixedSum2 own;
  own.add(e.direction_x, e.direction_y, 1048576.0f);
  return unitOf(own);
}

Sight look(const World& world, const std::vector<Entity>& all, const Entity& e) {
  const Rules::Steering& rules = world.rules.steering;
  const EnemyRules& type = world.rulesOf(e);
  Sight sight;
  cpu::FixedSum2 middle, heading;
  float nearest = 0.0f;
  for (const Entity& other : all) {
    const float x = other.x - e.x, y = other.y - e.y;
    if (other.type == e.type && other.id != e.id && x * x + y * y <= type.vision_m * type.vision_m) {
      ++sight.kin;
      middle.add(x, y, 1048576.0f);
      heading.add(other.direction_x, other.direction_y, 1048576.0f);
    }
    if (other.type != kTypeShot || type.machine == Machine::kamikaze) continue;
    if (x * x + y * y > rules.threat_m * rules.threat_m) continue;
    // From the shot to the enemy: ahead of it, and near enough to its line?
    const float ahead = other.direction_x * -x + other.direction_y * -y;
    const float aside = std::fabs(other.direction_x * -y - other.direction_y * -x);
    const float body = type.bounds == Bounds::circle
                           ? type.halfWidth_m
                           : std::sqrt(type.halfWidth_m * type.halfWidth_m + type.halfHeight_m * type.halfHeight_m);
    if (ahead <= 0.0f || aside > body + rules.threatMargin_m) continue;
    const float square = x * x + y * y;
    if (sight.shot && square >= nearest) continue;  // shots come by ascending id: the first of two wins
    sight.shot = &other;
    nearest = square;
  }
  sight.middle = unitOf(middle);
  sight.heading = unitOf(heading);
  return sight;
}

Vector drifted(const World& world, const Entity& e) {
  const uint32_t dice = cpu::philox(world.globals.seed, {world.globals.tick, e.id, kWanderPurpose, 0}).x;
  const float drift = (2.0f * cpu::unitFloat(dice) - 1.0f) * world.rules.steering.wanderDrift_rad;
  const float s = cpu::sine(drift), c = cpu::cosine(drift);
  return unit(e.direction_x * c - e.direction_y * s, e.direction_x * s + e.direction_y * c);
}

// Away from the ship, along walls, out of corners.
Vector flight(const World& world, const Entity& e, Vector toShip) {
  const float wall = world.rules.steering.escapeWall_m, width = world.limits.width_m, height = world.limits.height_m;
  const Vector away = unit(-(world.globals.ship.x - e.x), -(world.globals.ship.y - e.y));
  Vector way = away;
  if (way.x < 0.0f ? e.x < wall : e.x > width - wall) way.x = 0.0f;
  if (way.y < 0.0f ? e.y < wall : e.y > height - wall) way.y = 0.0f;
  if (way.x == 0.0f && way.y == 0.0f) {
    if (std::fabs(toShip.x) < std::fabs(toShip.y)) {
      way.x = e.x < width / 2 ? 1.0f : -1.0f;
    } else {
      way.y = e.y < height / 2 ? 1.0f : -1.0f;
    }
  }
  return unit(way.x, way.y);
}

// RULES, "how they think": the wish of each state; the force closes a share of the gap to it in one tick.
void steer(const World& world, Entity& e, const Sight& sight) {
  const Rules::Steering& r = world.rules.steering;
  const EnemyRules& type = world.rulesOf(e);
  const float ship_x = world.globals.ship.x - e.x, ship_y = world.globals.ship.y - e.y;
  const Vector toShip = unit(ship_x, ship_y);
  Vector way = toShip;
  float speed = type.speed_mps * world.globals.pace, response = r.response;
  bool keepsWay = true;  // its heading becomes its way
  Vector heading{e.direction_x, e.direction_y};
  switch (Mind(e.state)) {
    case Mind::attacking:
      if (type.machine == Machine::kamikaze) {
        if (e.energy < type.energy) speed = speed * r.damagedSpeed;
      } else if (type.machine == Machine::group) {
        way = unit(toShip.x + r.attackAlignment * sight.heading.x, toShip.y + r.attackAlignment * sight.heading.y);
      } else {
        const float far = std::sqrt(ship_x * ship_x + ship_y * ship_y) > r.sidewaysBeyond_m ? r.sideways : 0.0f;
        const float left = e.id % 2 ? far : -far;
        way = unit(toShip.x - left * toShip.y, toShip.y + left * toShip.x);
      }
      break;
    case Mind::avoiding:
      way = heading;
      speed = r.avoid_mps;
      response = r.avoidResponse;
      break;
    case Mind::escaping:
      way = flight(world, e, toShip);
      speed = type.speed_mps * world.globals.pace * r.escapeSpeed;
      e.energy = std::min(e.energy + r.recover_per_s * kTick_s, type.energy);
      break;
    case Mind::grouping:
      speed = type.speed_mps * world.globals.pace * r.wanderSpeed;
      way = heading;
      if (sight.kin == 0) break;  // until it asks again it flies on
      heading = drifted(world, e);
      way = unit(heading.x + r.wanderToShip * toShip.x + r.cohesion * sight.middle.x + r.alignment * sight.heading.x,
                 heading.y + r.wanderToShip * toShip.y + r.cohesion * sight.middle.y + r.alignment * sight.heading.y);
      break;
    case Mind::wandering:
      heading = drifted(world, e);
      way = unit(heading.x + r.wanderToShip * toShip.x, heading.y + r.wanderToShip * toShip.y);
      speed = type.speed_mps * world.globals.pace * r.wanderSpeed;
      keepsWay = false;
      break;
    case Mind::checkingEnergy:
    case Mind::dead:
      e.force_x = e.force_y = 0.0f;
      return;
  }
  const float share = e.mass * response * 60.0f;
  e.force_x = (way.x * speed - e.velocity_x) * share;
  e.force_y = (way.y * speed - e.velocity_y) * share;
  e.direction_x = keepsWay ? way.x : heading.x;
  e.direction_y = keepsWay ? way.y : heading.y;
}

void beginToAvoid(const World& world, Entity& e, const Entity& shot) {
  e.timer = world.rules.steering.avoid_ticks;
  e.cooldown = world.rulesOf(e).avoidCooldown_ticks;
  const float aside = shot.direction_x * (e.y - shot.y) - shot.direction_y * (e.x - shot.x);
  const bool left = aside == 0.0f ? e.id % 2 == 1 : aside > 0.0f;
  e.direction_x = left ? -shot.direction_y : shot.direction_y;
  e.direction_y = left ? shot.direction_x : -shot.direction_x;
}

void thinkEnemy(const World& world, const std::vector<Entity>& all, Entity& e) {
  if (world.isAnnounced(e)) return;
  const float x = world.globals.ship.x - e.x, y = world.globals.ship.y - e.y, distance = std::sqrt(x * x + y * y);
  const EnemyRules& type = world.rulesOf(e);
  const Rules::Steering& r = world.rules.steering;
  const Mind before = Mind(e.state);
  if (before == Mind::avoiding && e.timer > 0) --e.timer;
  if (e.cooldown > 0) --e.cooldown;
  const Sight sight = look(world, all, e);
  Facts facts;
  facts.damaged = e.flags & kFlagHit;
  facts.energyGone = e.energy <= 0.0f;
  facts.energyLow = e.energy < type.energy * r.escapeBelow;
  facts.recovered = e.energy >= type.energy * r.recoveredAt;
  facts.avoided = e.timer == 0;
  facts.shotComing = sight.shot && e.cooldown == 0;
  facts.seesShip = world.globals.allAttack || distance <= type.sight_m;
  facts.lostShip = !world.globals.allAttack && distance > type.sight_m * r.sightLost;
  // Company is asked for on every fourth tick, by turns; who attacks and sees the ship does not ask.
  const bool turn = (world.globals.tick + e.id) % 4 == 0, attacks = before == Mind::attacking;
  const bool charges = attacks && !facts.lostShip;
  const bool asks = before == Mind::wandering || before == Mind::grouping ? turn : attacks && !charges;
  facts.company = asks && sight.kin > 0;
  facts.alone = asks && sight.kin == 0;
  const Mind after = nextMind(type.machine, before, facts);
  e.state = uint32_t(after);
  e.transited = after != before;
  e.died = e.transited && after == Mind::dead;
  if (after == Mind::checkingEnergy) e.flags &= ~uint32_t(kFlagHit);
  if (e.transited && after == Mind::avoiding) beginToAvoid(world, e, *sight.shot);
  if (after == Mind::dead) return;
  Sight used = asks || (charges && turn) ? sight : Sight{};
  if (charges && !turn) used.heading = unitOfOwn(e);
  steer(world, e, used);
}

void thinkBit(const World& world, Entity& e) {
  const Rules::Bit& bit = world.rules.bit;
  const float x = world.globals.ship.x - e.x, y = world.globals.ship.y - e.y, distance = std::sqrt(x * x + y * y);
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

// The living states that only group and tricky, only tricky have.
bool hasState(Machine machine, Mind mind) {
  if (mind == Mind::escaping) return machine == Machine::tricky;
  if (mind == Mind::grouping || mind == Mind::avoiding) return machine != Machine::kamikaze;
  return true;
}

}  // namespace

Mind nextMind(Machine machine, Mind mind, const Facts& f) {
  if (mind == Mind::dead || !hasState(machine, mind)) return mind;
  const bool kamikaze = machine == Machine::kamikaze, tricky = machine == Machine::tricky;
  // 1: damaged, any living state.
  if (f.damaged) return Mind::checkingEnergy;
  // 2
  if (mind == Mind::checkingEnergy) {
    if (f.energyGone) return Mind::dead;
    if (tricky && f.energyLow) return Mind::escaping;
    return f.seesShip ? Mind::attacking : Mind::wandering;
  }
  // 3
  if (mind == Mind::escaping) return f.recovered ? Mind::wandering : mind;
  if (mind == Mind::avoiding) return f.avoided ? Mind::wandering : mind;
  // 4
  if (!kamikaze && f.shotComing) return Mind::avoiding;
  // 5
  if (mind != Mind::attacking && f.seesShip) return Mind::attacking;
  // 6, and a group of one is none
  if (mind == Mind::attacking) {
    if (!f.lostShip) return mind;
    return !kamikaze && f.company ? Mind::grouping : Mind::wandering;
  }
  if (kamikaze) return mind;
  if (mind == Mind::grouping) return f.alone ? Mind::wandering : mind;
  return f.company ? Mind::grouping : mind;
}

void think(World& world) {
  const std::vector<Entity> all = world.entities;  // all look at the same moment
  for (Entity& e : world.entities) {
    e.taken = e.died = e.transited = e.gone = false;
    if (world.isEnemy(e)) thinkEnemy(world, all, e);
    if (e.type == kTypeBit) thinkBit(world, e);
  }
}

}  // namespace gw::naive
