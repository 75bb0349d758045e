#include <algorithm>
#include <cmath>
#include <map>

#include "game/sim/entity_flags.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {
namespace {

constexpr float kNever = 2.0f;

struct Vector {
  float x, y;
};

float lengthOf(Vector v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

// |p + t d| = r: the smaller root.
float meetCircle(Vector p, Vector d, float r) {
  const float c = p.x * p.x + p.y * p.y - r * r;
  if (c <= 0.0f) return 0.0f;
  const float a = d.x * d.x + d.y * d.y, b = p.x * d.x + p.y * d.y;
  if (a <= 0.0f || b >= 0.0f) return kNever;
  const float under = b * b - a * c;
  if (under < 0.0f) return kNever;
  const float t = (-b - std::sqrt(under)) / a;
  if (t > 1.0f) return kNever;
  return t > 0.0f ? t : 0.0f;
}

// When the point is between two parallel lines, both ways.
bool narrow(float p, float d, float half, float& enter, float& leave) {
  if (d == 0.0f) return std::fabs(p) <= half;
  const float low = (-half - p) / d, high = (half - p) / d;
  enter = std::max(enter, std::min(low, high));
  leave = std::min(leave, std::max(low, high));
  return enter <= leave;
}

float meetBox(Vector p, Vector d, float halfWidth, float halfHeight) {
  float enter = 0.0f, leave = 1.0f;
  if (!narrow(p.x, d.x, halfWidth, enter, leave) || !narrow(p.y, d.y, halfHeight, enter, leave)) return kNever;
  return enter;
}

bool canBeHit(const World& world, const Entity& e) {
  return world.isEnemy(e) && e.energy > 0.0f && e.state != uint32_t(Mind::dead) && !world.isAnnounced(e);
}

// How far a must go to be free of b, and which way.
Vector depth(const EnemyRules& a, const EnemyRules& b, Vector d, float odd) {
  const bool boxA = a.bounds == Bounds::rectangle, boxB = b.bounds == Bounds::rectangle;
  const auto sideOf = [](float v, float tie) { return v > 0.0f ? 1.0f : v < 0.0f ? -1.0f : tie; };
  if (!boxA && !boxB) {
    const float r = a.halfWidth_m + b.halfWidth_m, distance = lengthOf(d);
    if (distance >= r) return {0, 0};
    if (distance == 0.0f) return {odd * r, 0};
    return {d.x / distance * (r - distance), d.y / distance * (r - distance)};
  }
  if (boxA && boxB) {
    const float x = a.halfWidth_m + b.halfWidth_m - std::fabs(d.x),
                y = a.halfHeight_m + b.halfHeight_m - std::fabs(d.y);
    if (x <= 0.0f || y <= 0.0f) return {0, 0};
    return x < y ? Vector{sideOf(d.x, odd) * x, 0} : Vector{0, sideOf(d.y, odd) * y};
  }
  if (boxA) {  // the other way round, and back
    const Vector turned = depth(b, a, {-d.x, -d.y}, -odd);
    return {-turned.x, -turned.y};
  }
  const float r = a.halfWidth_m;
  const Vector nearest = {std::clamp(d.x, -b.halfWidth_m, b.halfWidth_m),
                          std::clamp(d.y, -b.halfHeight_m, b.halfHeight_m)};
  const Vector out = {d.x - nearest.x, d.y - nearest.y};
  const float distance = lengthOf(out);
  if (distance > 0.0f) {
    if (distance >= r) return {0, 0};
    return {out.x / distance * (r - distance), out.y / distance * (r - distance)};
  }
  const float toSide = b.halfWidth_m - std::fabs(d.x), toTop = b.halfHeight_m - std::fabs(d.y);
  return toSide < toTop ? Vector{sideOf(d.x, odd) * (toSide + r), 0} : Vector{0, sideOf(d.y, odd) * (toTop + r)};
}

int64_t units(float value) {
  const double scaled = double(value) * 1048576.0;
  return int64_t(std::clamp(scaled, -1073741824.0, 1073741824.0));
}

void suffer(World& world, Entity& e, const std::vector<std::pair<float, uint32_t>>& chosenBy,
            std::vector<uint32_t>& spent) {
  if (chosenBy.empty()) return;
  const Rules& r = world.rules;
  for (const auto& [time, id] : chosenBy) {
    if (e.energy <= 0.0f) break;
    const Entity& shot = world.byId(id);
    e.energy -= shot.energy;
    const float kick = r.shot.knockBack_mps / e.mass;
    e.velocity_x += shot.direction_x * kick;
    e.velocity_y += shot.direction_y * kick;
    spent.push_back(id);
  }
  e.flags |= kFlagHit;
}

void meetShip(World& world, Entity& e) {
  const Rules& r = world.rules;
  const EnemyRules& type = world.rulesOf(e);
  GameGlobals& m = world.globals;
  if (world.isAnnounced(e) || e.energy <= 0.0f) return;
  const bool weak = type.energy <= r.ship.weakEnergy;
  const float fromShip = lengthOf({e.x - m.ship.x, e.y - m.ship.y}),
              fromFlush = lengthOf({e.x - m.flush_x, e.y - m.flush_y});
  const bool blasted = m.blast == kBlastNear && (e.id == m.blastId || (weak && fromShip <= r.ship.blast_m));
  if (blasted || m.blast == kBlastAll) {
    e.energy = 0.0f;
    e.flags |= kFlagHit | kFlagBlasted;
  } else if (m.flushRadius_m > 0.0f && fromFlush <= m.flushRadius_m + type.halfWidth_m) {
    e.energy = 0.0f;
    e.flags |= kFlagHit | kFlagFlushed;
  } else if (m.ship.untouchable_ticks == 0) {
    const float t = meeting(m.ship.previous_x - e.previous_x, m.ship.previous_y - e.previous_y,
                            (m.ship.x - m.ship.previous_x) - (e.x - e.previous_x),
                            (m.ship.y - m.ship.previous_y) - (e.y - e.previous_y), r.ship.radius_m, type);
    if (t > 1.0f) return;
    m.totals.contact = std::max(m.totals.contact, uint64_t(type.contact_us) << 32 | uint32_t(~e.id));
  }
}

struct Pressed {
  Vector push;
  float held;  // pushes that cancel, m/s
};

Pressed push(const World& world, const Entity& e) {
  int64_t x = 0, y = 0, all = 0;
  for (const Entity& other : world.entities) {
    if (!world.isEnemy(other) || other.id == e.id || other.state == uint32_t(Mind::dead)) continue;
    const Vector deep =
        depth(world.rulesOf(e), world.rulesOf(other), {e.x - other.x, e.y - other.y}, e.id < other.id ? 1.0f : -1.0f);
    const float share = other.mass / (e.mass + other.mass) * 30.0f;
    const int64_t aside = units(deep.x * share), up = units(deep.y * share);
    x += aside;
    y += up;
    all += std::abs(aside) + std::abs(up);
  }
  const Vector sum = {float(x) / 1048576.0f, float(y) / 1048576.0f};
  const float speed = lengthOf(sum), most = world.rules.steering.separation_mps;
  const float held = float(all - std::abs(x) - std::abs(y)) / 1048576.0f;
  return {speed > most ? Vector{sum.x * (most / speed), sum.y * (most / speed)} : sum, held};
}

// What flies against the push loses of that part of its velocity, all of it at the hardest push; and pushes that
// cancel hold it, half of its velocity at press_mps.
void yield(const World& world, Entity& e, const Pressed& pressed) {
  const Vector apart = pressed.push;
  const float speed = lengthOf(apart), press = world.rules.steering.press_mps,
              along = speed > 0.0f ? (e.velocity_x * apart.x + e.velocity_y * apart.y) / speed : 0.0f;
  if (along < 0.0f) {
    const float lost = along * (speed / world.rules.steering.separation_mps) / speed;
    e.velocity_x -= apart.x * lost;
    e.velocity_y -= apart.y * lost;
  }
  if (pressed.held == 0.0f) return;
  e.velocity_x *= press / (press + pressed.held);
  e.velocity_y *= press / (press + pressed.held);
}

}  // namespace

float meeting(float x, float y, float dx, float dy, float radius, const EnemyRules& body) {
  const float w = body.halfWidth_m, h = body.halfHeight_m;
  if (body.bounds == Bounds::circle) return meetCircle({x, y}, {dx, dy}, w + radius);
  float first = std::min(meetBox({x, y}, {dx, dy}, w + radius, h), meetBox({x, y}, {dx, dy}, w, h + radius));
  for (const float cx : {-w, w}) {
    for (const float cy : {-h, h}) first = std::min(first, meetCircle({x - cx, y - cy}, {dx, dy}, radius));
  }
  return first;
}

void collide(World& world) {
  struct Choice {
    float time;
    uint32_t victim;
  };
  std::map<uint32_t, Choice> choices;                                    // by shot
  std::map<uint32_t, std::vector<std::pair<float, uint32_t>>> chosenBy;  // by victim: (time, shot)
  for (const Entity& shot : world.entities) {
    if (shot.type != kTypeShot) continue;
    Choice best{kNever, kNobody};
    for (const Entity& e : world.entities) {
      if (!canBeHit(world, e) || e.id == shot.target || e.id == shot.flags) continue;
      const float t =
          meeting(shot.previous_x - e.previous_x, shot.previous_y - e.previous_y,
                  (shot.x - shot.previous_x) - (e.x - e.previous_x), (shot.y - shot.previous_y) - (e.y - e.previous_y),
                  world.rules.shot.radius_m, world.rulesOf(e));
      if (t < best.time && t <= 1.0f) best = {t, e.id};  // ids ascend: the lowest wins a tie
    }
    if (best.victim == kNobody) continue;
    choices[shot.id] = best;
    chosenBy[best.victim].push_back({best.time, shot.id});
  }
  std::vector<uint32_t> spent;
  for (Entity& e : world.entities) {
    if (!world.isEnemy(e) || e.state == uint32_t(Mind::dead)) continue;
    std::sort(chosenBy[e.id].begin(), chosenBy[e.id].end());
    suffer(world, e, chosenBy[e.id], spent);
    meetShip(world, e);
    const Pressed pressed = push(world, e);
    e.push_x = pressed.push.x;
    e.push_y = pressed.push.y;
    yield(world, e, pressed);
  }
  for (const auto& [id, choice] : choices) {
    Entity& shot = world.byId(id);
    shot.gone = shot.timer == 0;  // a shot that leaves the world has hit its victim first
    shot.x = shot.previous_x + (shot.x - shot.previous_x) * choice.time;
    shot.y = shot.previous_y + (shot.y - shot.previous_y) * choice.time;
    if (std::find(spent.begin(), spent.end(), id) == spent.end()) continue;
    shot.flags = shot.target;
    shot.target = choice.victim;
    if (--shot.cooldown == 0) shot.gone = true;
  }
}

}  // namespace gw::naive
