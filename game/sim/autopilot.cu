// Autopilot: leaves the host's input record for this tick, or puts a bot's in its place, which is then what
// gets recorded. Bots see what a player sees: no states, only what is within the view, and late: a place is
// taken back along its velocity by the bot's reaction time.
#include "game/sim/stages.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kTen = 3;  // index into kPracticeCounts
constexpr float kView_x_m = 36.0f, kView_y_m = 20.0f;

// A body as a bot sees it, relative to the ship.
struct Observed {
  float x, y, velocity_x, velocity_y, radius, distance2;
  uint32_t id;
};

// What both bots do: observe, and turn a decision into a record.
template <class Search>
struct Bot {
  View v;
  Search search;

  // Calls see(Observed, type) for what is alive and in view within radius, as it was `late` ticks ago.
  template <class See>
  GW_BODY void observe(float radius, float late_ticks, const See& see) const {
    const Ship& ship = v.globals->ship;
    search({ship.x, ship.y}, radius, [&](const Cell& cell, uint32_t place, Float2) {
      const Cell now = v.cells[place];  // the same cell at the end of the tick that was searched
      if (now.type == kTypeNone || now.type == kTypeShot) return;
      if (isEnemy(now.type) && v.state[cell.id].x == uint32_t(State::dead)) return;
      const Float4 motion = v.velocityPrevious[cell.id];
      const float back = late_ticks * kTick_s;
      Observed observed{
          now.x - motion.x * back - ship.x, now.y - motion.y * back - ship.y, motion.x, motion.y, 0.0f, 0.0f, cell.id};
      if (magnitude(observed.x) > kView_x_m || magnitude(observed.y) > kView_y_m) return;
      observed.radius = isEnemy(now.type) ? v.tables->rules.enemies[now.type].halfWidth_m : 0.0f;
      observed.distance2 = observed.x * observed.x + observed.y * observed.y;
      see(observed, now.type);
    });
  }

  GW_BODY static int16_t stick(float component) { return int16_t(clamp(component, -1.0f, 1.0f) * float(kStickFull)); }

  GW_BODY static uint16_t turns(float angle_rad) {
    const float share = angle_rad / kTwoPi;
    return uint16_t(uint32_t(int32_t(clamp(share, -4.0f, 4.0f) * 65536.0f)) & 0xFFFFu);
  }

  // Practice has no waves: every 4 s it asks for ten of the next type.
  GW_BODY void requestEnemies(InputRecord& input, uint32_t every_ticks) const {
    const uint32_t tick = v.globals->tick;
    if (v.tables->mode != Mode::practice || tick % 240 >= every_ticks) return;
    const uint32_t type = tick / 240 % v.tables->rules.enemyTypeCount;
    input.buttons |= uint16_t(kButtonSpawn | type << kSpawnTypeShift | kTen << kSpawnCountShift);
  }

  // Uniform in -1..1, the same for the whole tick.
  GW_BODY float aimError() const {
    const GameGlobals& m = *v.globals;
    return 2.0f * unitFloat(philox(m.seed, {m.tick, 0, kPurposeAutopilot, 0}).x) - 1.0f;
  }
};

// RULES, novice: aims at the nearest without lead; flees the nearest within 7 m, else fetches bits, else
// goes to the middle; flushes half of the time when it is crowded.
template <class Search>
struct Novice : Bot<Search> {
  using Bot<Search>::v;
  static constexpr uint32_t kEvery_ticks = 18;
  static constexpr float kLate_ticks = 18.0f;

  GW_BODY void operator()(uint32_t) const {
    v.scratch->input = v.globals->tick % kEvery_ticks == 0 ? decide() : v.globals->input;
  }

  GW_BODY InputRecord decide() const {
    const GameGlobals& m = *v.globals;
    const float far2 = 1.0e9f;
    Observed nearest{0, 0, 0, 0, 0, far2, kNobody}, bit{0, 0, 0, 0, 0, far2, kNobody};
    uint32_t close = 0;
    this->observe(42.0f, kLate_ticks, [&](const Observed& observed, uint32_t type) {
      Observed& best = isEnemy(type) ? nearest : bit;
      if (isEnemy(type) && observed.distance2 <= 25.0f) ++close;
      if (observed.distance2 < best.distance2 || (observed.distance2 == best.distance2 && observed.id < best.id))
        best = observed;
    });

    InputRecord input;
    float x = 0.5f * v.tables->limits.width_m - m.ship.x, y = 0.5f * v.tables->limits.height_m - m.ship.y;
    if (nearest.distance2 <= 49.0f) {
      x = -nearest.x;
      y = -nearest.y;
    } else if (bit.distance2 <= 100.0f) {
      x = bit.x;
      y = bit.y;
    } else if (length(x, y) < 4.0f) {
      x = y = 0.0f;
    }
    const Float2 direction = normalised(x, y);
    input.move_x = this->stick(direction.x);
    input.move_y = this->stick(direction.y);
    if (nearest.id != kNobody) {
      constexpr float kError_rad = 0.2617994f;  // 15 degrees
      input.aim = this->turns(arcTangent2(nearest.y, nearest.x) + this->aimError() * kError_rad);
      input.buttons = kButtonFire;
    }
    const bool crowded = close > 30 || (m.frameTime_us > 60000 && close >= 5);
    const Uint4 coin = philox(m.seed, {m.tick, 1, kPurposeAutopilot, 0});
    if (crowded && (coin.x & 1u)) input.buttons |= kButtonFlush;
    this->requestEnemies(input, kEvery_ticks);
    return input;
  }
};

// RULES, expert: shoots what will touch it soonest, with lead; moves the best of 17 directions against the
// nearest 96 bodies within 18 m, looking 0.72 s ahead; bits attract.
template <class Search>
struct Expert : Bot<Search> {
  using Bot<Search>::v;
  static constexpr uint32_t kEvery_ticks = 4, kMost = 96, kDirections = 17;
  static constexpr float kLate_ticks = 6.0f, kAhead_s = 0.72f, kNear_m = 18.0f;

  struct Field {
    Observed bodies[kMost];
    uint32_t count = 0;
    uint32_t close = 0;  // within 5 m
    Observed bit{0, 0, 0, 0, 0, 1.0e9f, kNobody};
  };

  GW_BODY void operator()(uint32_t) const {
    v.scratch->input = v.globals->tick % kEvery_ticks == 0 ? decide() : v.globals->input;
  }

  GW_BODY InputRecord decide() const {
    const GameGlobals& m = *v.globals;
    Field field;
    this->observe(kNear_m + 4.0f, kLate_ticks,
                  [&](const Observed& observed, uint32_t type) { keep(field, observed, type); });
    InputRecord input;
    float bestScore = 0.0f;
    const Float2 direction = bestDirection(field, bestScore);
    input.move_x = this->stick(direction.x);
    input.move_y = this->stick(direction.y);
    aim(field, input);
    const bool trapped = bestScore < -12.0f && field.close >= 5;
    if (field.close >= 14 || trapped || (m.frameTime_us > 70000 && field.close >= 4)) input.buttons |= kButtonFlush;
    this->requestEnemies(input, kEvery_ticks);
    return input;
  }

 private:
  GW_BODY static bool nearer(const Observed& a, const Observed& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.id < b.id);
  }

  // Keeps the nearest kMost bodies in order: insertion, so the order of visits does not matter.
  GW_BODY static void keep(Field& field, Observed observed, uint32_t type) {
    if (!isEnemy(type)) {
      if (nearer(observed, field.bit)) field.bit = observed;
      return;
    }
    if (observed.distance2 <= 25.0f) ++field.close;
    if (observed.distance2 > kNear_m * kNear_m) return;
    if (field.count == kMost && !nearer(observed, field.bodies[kMost - 1])) return;
    uint32_t hole = field.count < kMost ? field.count++ : kMost - 1;
    while (hole > 0 && nearer(observed, field.bodies[hole - 1])) {
      field.bodies[hole] = field.bodies[hole - 1];
      --hole;
    }
    field.bodies[hole] = observed;
  }

  // How much room a direction leaves: for each body the smallest gap within the time ahead, small gaps hurt most.
  GW_BODY float scoreOf(const Field& field, Float2 direction) const {
    const GameGlobals& m = *v.globals;
    const Rules& r = v.tables->rules;
    const Limits& limits = v.tables->limits;
    const float speed = r.ship.speed_mps;
    float score = 0.0f;
    for (uint32_t i = 0; i < field.count; ++i) {
      const Observed& body = field.bodies[i];
      const float late = kLate_ticks * kTick_s;
      const float x = body.x + body.velocity_x * late, y = body.y + body.velocity_y * late;
      const float dx = body.velocity_x - direction.x * speed, dy = body.velocity_y - direction.y * speed;
      const float d2 = dx * dx + dy * dy;
      float t = d2 > 0.0f ? -(x * dx + y * dy) / d2 : 0.0f;
      t = clamp(t, 0.0f, kAhead_s);
      const float gap = length(x + dx * t, y + dy * t) - body.radius - r.ship.radius_m;
      if (gap < 2.5f) score -= (2.5f - gap) * (2.5f - gap) * (gap < 0.3f ? 6.0f : 1.0f);
      if (gap < 6.0f) score -= (6.0f - gap) * 0.05f;
    }
    const float x = m.ship.x + direction.x * speed * kAhead_s, y = m.ship.y + direction.y * speed * kAhead_s;
    const float wall = smaller(smaller(x, limits.width_m - x), smaller(y, limits.height_m - y));
    if (wall < 14.0f) score -= (14.0f - wall) * 0.6f;
    if (field.bit.id != kNobody) {
      const Float2 toBit = normalised(field.bit.x, field.bit.y);
      score += 1.2f * (direction.x * toBit.x + direction.y * toBit.y);
    }
    return score;
  }

  GW_BODY Float2 bestDirection(const Field& field, float& score) const {
    Float2 best{0.0f, 0.0f};
    score = scoreOf(field, best);
    for (uint32_t k = 0; k + 1 < kDirections; ++k) {
      const SineCosine at = sineCosine(float(k) * (kTwoPi / float(kDirections - 1)));
      const Float2 direction{at.cosine, at.sine};
      const float here = scoreOf(field, direction);
      if (here > score) {
        score = here;
        best = direction;
      }
    }
    return best;
  }

  GW_BODY void aim(const Field& field, InputRecord& input) const {
    const Rules& r = v.tables->rules;
    const GameGlobals& m = *v.globals;
    float soonest = 1.0e9f;
    const Observed* target = nullptr;
    for (uint32_t i = 0; i < field.count; ++i) {
      const Observed& body = field.bodies[i];
      const float distance = sqrtf(body.distance2);
      const float closing = distance > 0.0f ? -(body.x * body.velocity_x + body.y * body.velocity_y) / distance : 0.0f;
      const float contact = (distance - body.radius) / larger(closing + 3.0f, 1.0f);
      if (contact < soonest) {
        soonest = contact;
        target = &body;
      }
    }
    input.aim = this->turns(m.ship.aim_rad);
    if (!target) return;
    const float lead = sqrtf(target->distance2) / r.shot.speed_mps + kLate_ticks * kTick_s;
    const float x = target->x + target->velocity_x * lead, y = target->y + target->velocity_y * lead;
    constexpr float kError_rad = 0.0349066f;  // 2 degrees
    input.aim = this->turns(arcTangent2(y, x) + this->aimError() * kError_rad);
    input.buttons = kButtonFire;
  }
};

}  // namespace

void autopilot(Queue& queue, const View& view, Autopilot who) {
  const Count one{1};
  if (who == Autopilot::none) return;
  withSearchFromAnywhere(view.seen, [&](auto search) {  // the ship is in no cell
    using Search = decltype(search);
    if (who == Autopilot::novice) {
      forEach(queue, one, Novice<Search>{{view, search}});
    } else {
      forEach(queue, one, Expert<Search>{{view, search}});
    }
  });
}

}  // namespace gw::GW_DEVICE
