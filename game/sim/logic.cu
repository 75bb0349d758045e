// Logic. One item, O(1): it never loops over entities, only over rules and commands.
#include "game/sim/behaviour/waves.h"
#include "game/sim/stages.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kMuzzle_m = 0.55f;  // from the ship's middle to where shots are born

struct GameLogic {
  View v;

  GW_BODY void operator()(uint32_t) const {
    GameGlobals& m = *v.globals;
    TickScratch& s = *v.scratch;
    const Rules& r = v.tables->rules;
    s.commandCount = s.births = 0;
    s.shotSounds = s.waveSounds = s.flushSounds = s.overSounds = s.contactSounds = 0;
    s.contactType = kTypeNone;
    s.contactCost_us = 0;
    s.tally = Tally{};
    for (uint64_t& pop : s.pops) pop = 0;
    s.longestStep2 = 0;
    if (m.over) return;

    ++m.tick;
    const Totals last = m.totals;
    countKills(m, r, last);
    applyContact(m, s, r, last);
    m.over = uint32_t(endingOf(m, r, last));
    if (m.over) {
      m.totals.contact = 0;
      s.overSounds = 1;
      return;
    }
    m.totals = Totals{};
    s.bitRoom = kBitCapacity - smaller(kBitCapacity, last.occupied[kTypeBit]);
    moveShip(m, r, s.input);
    fireSalvo(m, s, r, s.input, last);
    updateFlush(m, s, r, s.input);
    Waves{m, s, *v.tables, last}.run();
    m.input = s.input;
  }

  // What died and what was collected in the last tick.
  GW_BODY void countKills(GameGlobals& m, const Rules& r, const Totals& last) const {
    uint64_t points = 0, bare = 0;
    uint32_t enemies = 0;
    for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) {
      points += uint64_t(last.kills[t]) * r.enemies[t].value;
      bare += uint64_t(last.bareKills[t]) * r.enemies[t].value;
      m.killsByType[t] += last.kills[t] + last.bareKills[t];
      m.kills += last.kills[t] + last.bareKills[t];
      enemies += last.occupied[t];
    }
    m.score += points * m.multiplierTenths / 10 + bare;
    m.multiplierTenths += last.bitsTaken * r.bit.multiplierTenths;
    m.bitsTaken += last.bitsTaken;
    m.refused += last.refusedBits;
    m.peakEnemies = larger(m.peakEnemies, enemies - last.dying);
    while (m.flushScores < r.flush.scoreCount && m.score >= r.flush.scores[m.flushScores]) {
      ++m.flushScores;
      if (m.flushes < r.flush.most) ++m.flushes;
    }
    // Bits give time back, out of a bank that fills slowly: a horde of bits must not make the run endless.
    m.bank_us = smaller(m.bank_us + r.budget.bankFill_us, r.budget.bankMax_us);
    uint32_t back = smaller(last.bitsTaken * r.budget.bitReturns_us, m.bank_us);
    back = smaller(back, m.frameTime_us - smaller(m.frameTime_us, r.budget.start_us));
    m.bank_us -= back;
    m.frameTime_us -= back;
  }

  // One contact a tick, the costliest, then the lowest id.
  GW_BODY void applyContact(GameGlobals& m, TickScratch& s, const Rules& r, const Totals& last) const {
    m.blast = kBlastNone;
    m.blastId = kNobody;
    if (m.ship.untouchable_ticks > 0) --m.ship.untouchable_ticks;
    if (last.contact == 0) return;
    const uint32_t cost = uint32_t(last.contact >> 32), who = ~uint32_t(last.contact);
    charge(m, r, cost);
    m.ship.untouchable_ticks = r.ship.untouchable_ticks;
    m.blast = kBlastNear;
    m.blastId = who;
    ++m.contacts;
    s.contactSounds = 1;
    s.contactType = v.cells[v.cellOf[who]].type;
    s.contactCost_us = cost;
  }

  // Frame time, or the clock; practice has no end.
  GW_BODY void charge(GameGlobals& m, const Rules& r, uint32_t cost_us) const {
    if (v.tables->mode == Mode::deadline) {
      m.clock_ticks -= smaller(m.clock_ticks, cost_us * r.deadline.contactTicks_per_ms / 1000);
    } else {
      m.frameTime_us += cost_us;
    }
    if (v.tables->mode == Mode::practice) m.frameTime_us = smaller(m.frameTime_us, r.budget.limit_us);
  }

  GW_BODY Ending endingOf(GameGlobals& m, const Rules& r, const Totals& last) const {
    if (m.frameTime_us > r.budget.limit_us) return Ending::frameRate;
    if (v.tables->mode == Mode::deadline) {
      if (m.clock_ticks == 0) return Ending::timeUp;
      --m.clock_ticks;
    }
    if (v.tables->mode == Mode::swarm && m.tick > 1) {
      uint32_t enemies = 0;
      for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) enemies += last.occupied[t];
      if (enemies == last.dying) return Ending::cleared;
    }
    return Ending::none;
  }

  GW_BODY void moveShip(GameGlobals& m, const Rules& r, InputRecord input) const {
    Ship& ship = m.ship;
    float wish_x = float(input.move_x) / float(kStickFull), wish_y = float(input.move_y) / float(kStickFull);
    const float l = length(wish_x, wish_y);
    if (l > 1.0f) {
      wish_x = wish_x / l;
      wish_y = wish_y / l;
    }
    ship.velocity_x += (wish_x * r.ship.speed_mps - ship.velocity_x) * r.ship.response;
    ship.velocity_y += (wish_y * r.ship.speed_mps - ship.velocity_y) * r.ship.response;
    ship.previous_x = ship.x;
    ship.previous_y = ship.y;
    ship.x += ship.velocity_x * kTick_s;
    ship.y += ship.velocity_y * kTick_s;
    const float right = v.tables->limits.width_m - r.ship.radius_m, top = v.tables->limits.height_m - r.ship.radius_m;
    if (ship.x < r.ship.radius_m || ship.x > right) ship.velocity_x = 0.0f;
    if (ship.y < r.ship.radius_m || ship.y > top) ship.velocity_y = 0.0f;
    ship.x = clamp(ship.x, r.ship.radius_m, right);
    ship.y = clamp(ship.y, r.ship.radius_m, top);
    ship.aim_rad = float(input.aim) * (kTwoPi / 65536.0f);
  }

  GW_BODY void fireSalvo(GameGlobals& m, TickScratch& s, const Rules& r, InputRecord input, const Totals& last) const {
    if (m.ship.fire_ticks > 0) --m.ship.fire_ticks;
    if (!(input.buttons & kButtonFire) || m.ship.fire_ticks > 0) return;
    uint32_t level = 0;
    while (level + 1 < r.shot.levelCount && m.multiplierTenths >= r.shot.levels[level + 1].fromTenths) ++level;
    const ShotLevel& shot = r.shot.levels[level];
    m.ship.fire_ticks = shot.every_ticks;
    s.shotSounds = 1;
    const SineCosine aim = sineCosine(m.ship.aim_rad);
    Command salvo;
    salvo.type = kTypeShot;
    salvo.count = shot.count;
    salvo.x = m.ship.x + aim.cosine * kMuzzle_m;
    salvo.y = m.ship.y + aim.sine * kMuzzle_m;
    salvo.angle_rad = m.ship.aim_rad;
    salvo.spread_rad = shot.spread_rad;
    salvo.hits = shot.hits;
    queueCommand(m, s, salvo, kShotCapacity - smaller(kShotCapacity, last.occupied[kTypeShot]));
  }

  // The ring of the flush; what it meets is collide's work.
  GW_BODY void updateFlush(GameGlobals& m, TickScratch& s, const Rules& r, InputRecord input) const {
    if (m.flushRadius_m > 0.0f) {
      m.flushRadius_m += r.flush.speed_mps * kTick_s;
      if (m.flushRadius_m > r.flush.reach_m) m.flushRadius_m = 0.0f;
    }
    const bool pressed = (input.buttons & kButtonFlush) && !(m.input.buttons & kButtonFlush);
    if (!pressed || m.flushes == 0 || m.flushRadius_m > 0.0f) return;
    --m.flushes;
    m.flush_x = m.ship.x;
    m.flush_y = m.ship.y;
    m.flushRadius_m = r.flush.speed_mps * kTick_s;
    m.ship.untouchable_ticks = larger(m.ship.untouchable_ticks, r.flush.untouchable_ticks);
    s.flushSounds = 1;
  }
};

}  // namespace

void logic(Queue& queue, const View& view) {
  forEach(queue, Count{1}, GameLogic{view});
}

}  // namespace gw::GW_DEVICE
