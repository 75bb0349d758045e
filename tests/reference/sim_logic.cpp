#include <algorithm>
#include <cmath>

#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {
namespace {

constexpr uint32_t kCommandPurpose = 2, kEndlessPurpose = 5;
constexpr float kMuzzle = 0.55f;

void scoreLastTick(World& world) {
  GameGlobals& m = world.globals;
  const Rules& r = world.rules;
  uint32_t alive = 0;
  uint64_t full = 0, bare = 0;
  for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) {
    const uint32_t shot = m.totals.kills[t], flushed = m.totals.bareKills[t];
    full += uint64_t(shot) * r.enemies[t].value;
    bare += uint64_t(flushed) * r.enemies[t].value;
    m.kills += shot + flushed;
    m.killsByType[t] += shot + flushed;
    alive += m.totals.occupied[t];
  }
  m.score += full * m.multiplierTenths / 10 + bare;
  m.peakEnemies = std::max(m.peakEnemies, alive - m.totals.dying);
  m.bitsTaken += m.totals.bitsTaken;
  m.multiplierTenths += m.totals.bitsTaken * r.bit.multiplierTenths;
  for (; m.flushScores < r.flush.scoreCount && m.score >= r.flush.scores[m.flushScores]; ++m.flushScores) {
    m.flushes = std::min(m.flushes + 1, std::max(m.flushes, r.flush.most));
  }
  m.bank_us = std::min(m.bank_us + r.budget.bankFill_us, r.budget.bankMax_us);
  const uint32_t slow = m.frameTime_us > r.budget.start_us ? m.frameTime_us - r.budget.start_us : 0;
  const uint32_t back = std::min({m.totals.bitsTaken * r.budget.bitReturns_us, m.bank_us, slow});
  m.bank_us -= back;
  m.frameTime_us -= back;
}

void sufferContact(World& world) {
  GameGlobals& m = world.globals;
  if (m.ship.untouchable_ticks > 0) --m.ship.untouchable_ticks;
  m.blast = kBlastNone;
  m.blastId = kNobody;
  if (m.totals.contact == 0) return;
  m.blast = kBlastNear;
  m.blastId = ~uint32_t(m.totals.contact);
  const uint32_t cost_us = uint32_t(m.totals.contact >> 32);
  if (world.mode == Mode::deadline) {
    const uint32_t ticks = cost_us * world.rules.deadline.contactTicks_per_ms / 1000;
    m.clock_ticks = m.clock_ticks > ticks ? m.clock_ticks - ticks : 0;
  } else {
    m.frameTime_us += cost_us;
  }
  if (world.mode == Mode::practice) m.frameTime_us = std::min(m.frameTime_us, world.rules.budget.limit_us);
  m.ship.untouchable_ticks = world.rules.ship.untouchable_ticks;
  ++m.contacts;
}

uint32_t enemiesOf(const Totals& totals) {
  uint32_t enemies = 0;
  for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) enemies += totals.occupied[t];
  return enemies;
}

Ending endOf(World& world) {
  GameGlobals& m = world.globals;
  if (m.frameTime_us > world.rules.budget.limit_us) return Ending::frameRate;
  if (world.mode == Mode::deadline && m.clock_ticks-- == 0) {
    m.clock_ticks = 0;
    return Ending::timeUp;
  }
  const bool cleared = world.mode == Mode::swarm && m.tick > 1 && enemiesOf(m.totals) == m.totals.dying;
  return cleared ? Ending::cleared : Ending::none;
}

void moveAxis(float& place, float& previous, float& velocity, float wish, float size, const Rules& r) {
  velocity += (wish * r.ship.speed_mps - velocity) * r.ship.response;
  previous = place;
  place += velocity * kTick_s;
  const float low = r.ship.radius_m, high = size - r.ship.radius_m;
  if (place >= low && place <= high) return;
  place = place < low ? low : high;
  velocity = 0.0f;
}

void flyShip(World& world) {
  Ship& ship = world.globals.ship;
  float x = float(world.input.move_x) / 32767.0f, y = float(world.input.move_y) / 32767.0f;
  const float l = std::sqrt(x * x + y * y);
  if (l > 1.0f) {
    x /= l;
    y /= l;
  }
  moveAxis(ship.x, ship.previous_x, ship.velocity_x, x, world.limits.width_m, world.rules);
  moveAxis(ship.y, ship.previous_y, ship.velocity_y, y, world.limits.height_m, world.rules);
  ship.aim_rad = float(world.input.aim) * (6.28318530717959f / 65536.0f);
}

uint32_t order(World& world, Command command, uint32_t room) {
  uint32_t before = 0;
  for (const Command& c : world.commands) before += c.count;
  const uint32_t fits = world.commands.size() < kMaxCommands ? std::min(command.count, room) : 0;
  world.globals.refused += command.count - fits;
  if (fits == 0) return 0;
  command.count = fits;
  command.firstBirth = before;
  world.commands.push_back(command);
  return fits;
}

void fireShots(World& world, const Totals& last) {
  Ship& ship = world.globals.ship;
  if (ship.fire_ticks > 0) --ship.fire_ticks;
  if ((world.input.buttons & kButtonFire) == 0 || ship.fire_ticks > 0) return;
  const Rules::Shot& shot = world.rules.shot;
  ShotLevel level = shot.levels[0];
  for (uint32_t i = 0; i < shot.levelCount; ++i) {
    if (world.globals.multiplierTenths >= shot.levels[i].fromTenths) level = shot.levels[i];
  }
  ship.fire_ticks = level.every_ticks;
  Command salvo;
  salvo.type = kTypeShot;
  salvo.count = level.count;
  salvo.hits = level.hits;
  salvo.spread_rad = level.spread_rad;
  salvo.angle_rad = ship.aim_rad;
  salvo.x = ship.x + cpu::cosine(ship.aim_rad) * kMuzzle;
  salvo.y = ship.y + cpu::sine(ship.aim_rad) * kMuzzle;
  const uint32_t flying = last.occupied[kTypeShot];
  order(world, salvo, flying < kShotCapacity ? kShotCapacity - flying : 0);
}

void growFlush(World& world) {
  GameGlobals& m = world.globals;
  const Rules::Flush& f = world.rules.flush;
  if (m.flushRadius_m > 0.0f) m.flushRadius_m += f.speed_mps * kTick_s;
  if (m.flushRadius_m > f.reach_m) m.flushRadius_m = 0.0f;
  const bool wasDown = m.input.buttons & kButtonFlush, isDown = world.input.buttons & kButtonFlush;
  if (!isDown || wasDown || m.flushRadius_m > 0.0f || m.flushes == 0) return;
  --m.flushes;
  m.flush_x = m.ship.x;
  m.flush_y = m.ship.y;
  m.flushRadius_m = f.speed_mps * kTick_s;
  m.ship.untouchable_ticks = std::max(m.ship.untouchable_ticks, f.untouchable_ticks);
}

void bringGroup(World& world, uint32_t type, uint32_t count, Pattern pattern, uint32_t& room) {
  const GameGlobals& m = world.globals;
  Command c;
  c.type = type;
  c.count = count;
  c.pattern = pattern;
  c.x = m.ship.x;
  c.y = m.ship.y;
  const auto dice = cpu::philox(m.seed, {m.tick, uint32_t(world.commands.size()), kCommandPurpose, 0});
  c.angle_rad = cpu::unitFloat(dice.x) * 6.28318530717959f;
  room -= order(world, c, room);
}

void bringEndless(World& world, uint32_t& room) {
  GameGlobals& m = world.globals;
  const Rules::Endless& e = world.rules.endless;
  ++m.endless;
  m.endlessPoints = std::min(m.endlessPoints * e.growth, 1.0e6f);
  m.pace = std::min(m.pace * e.paceGrowth, e.paceMost);
  const uint32_t groups = 1 + m.endless % 3;
  for (uint32_t g = 0; g < groups; ++g) {
    const auto dice = cpu::philox(m.seed, {m.tick, g, kEndlessPurpose, 0});
    std::vector<uint32_t> urn;  // one ball per percent
    for (uint32_t t = 0; t < world.rules.enemyTypeCount; ++t) urn.insert(urn.end(), e.chance_percent[t], t);
    const uint32_t type = urn[dice.x % urn.size()];
    const float count = std::clamp(m.endlessPoints / (float(groups) * e.price[type]), 1.0f, 1.0e6f);
    bringGroup(world, type, uint32_t(count), Pattern(dice.y % uint32_t(Pattern::count)), room);
  }
}

uint32_t roomFor(const World& world, const Totals& last) {
  const uint32_t alive = enemiesOf(last);
  return alive < world.limits.enemies ? world.limits.enemies - alive : 0;
}

// All in the first tick, each type by its share of points over its price; what is left over is of the first.
void bringSwarm(World& world, const Totals& last) {
  GameGlobals& m = world.globals;
  const Rules& r = world.rules;
  if (m.tick > 1) {
    const uint32_t alive = enemiesOf(last) - last.dying;
    if (float(alive) <= float(world.limits.enemies) * r.swarm.attackShare) m.allAttack = 1;
    return;
  }
  uint32_t room = roomFor(world, last), left = room;
  float sum = 0.0f;
  std::vector<uint32_t> counts;
  for (uint32_t t = 0; t < r.enemyTypeCount; ++t) sum += float(r.endless.chance_percent[t]) / r.endless.price[t];
  for (uint32_t t = 0; t < r.enemyTypeCount; ++t) {
    const float share = float(r.endless.chance_percent[t]) / r.endless.price[t] / sum;
    counts.push_back(std::min(left, uint32_t(float(room) * share)));
    left -= counts.back();
  }
  counts[0] += left;
  for (uint32_t t = 0; t < r.enemyTypeCount; ++t) {
    if (counts[t]) bringGroup(world, t, counts[t], Pattern::rain, room);
  }
  m.wave = 1;
}

// The press of a button brings what its other bits say.
void bringAsked(World& world, const Totals& last) {
  GameGlobals& m = world.globals;
  const auto goesDown = [&](uint32_t button) {
    return (world.input.buttons & button) != 0 && (m.input.buttons & button) == 0;
  };
  if (goesDown(kButtonClear)) m.blast = kBlastAll;
  const uint32_t type = (world.input.buttons >> 4) % 8, number = (world.input.buttons >> 8) % 16;
  if (!goesDown(kButtonSpawn) || type >= world.rules.enemyTypeCount || number >= std::size(kPracticeCounts)) return;
  uint32_t room = roomFor(world, last);
  bringGroup(world, type, kPracticeCounts[number], Pattern(m.wave % uint32_t(Pattern::count)), room);
  ++m.wave;
}

void bringWaves(World& world, const Totals& last) {
  GameGlobals& m = world.globals;
  const Rules& r = world.rules;
  const uint32_t rate = world.mode == Mode::deadline ? r.deadline.waveRate : 1;
  uint32_t room = roomFor(world, last);
  const bool scripted = m.wave < r.waveCount;
  const uint32_t due = scripted ? r.waves[m.wave].at_ticks : r.endless.from_ticks + m.endless * r.endless.every_ticks;
  const bool idle = m.tick > 1 && last.inView < r.idle.fewerThan && last.coming < r.idle.fewerThan;
  m.idle_ticks = idle ? m.idle_ticks + 1 : 0;
  if (m.idle_ticks >= r.idle.wait_ticks && m.waveClock_ticks < due) {
    const uint32_t saved_ticks = (due - m.waveClock_ticks) / rate;
    m.score += uint64_t(r.idle.pays) * m.multiplierTenths * saved_ticks / 600;
    m.waveClock_ticks = due;
    m.idle_ticks = 0;
  }
  const bool begins = m.waveClock_ticks >= due;
  m.waveClock_ticks += rate;
  if (!begins) return;
  if (!scripted) return bringEndless(world, room);
  const Wave& wave = r.waves[m.wave++];
  for (uint32_t g = 0; g < wave.groupCount; ++g) {
    bringGroup(world, wave.groups[g].type, wave.groups[g].count, wave.groups[g].pattern, room);
  }
}

}  // namespace

void logic(World& world) {
  GameGlobals& m = world.globals;
  world.commands.clear();
  if (m.over) return;
  ++m.tick;
  scoreLastTick(world);
  sufferContact(world);
  m.over = uint32_t(endOf(world));
  if (m.over) {
    m.totals.contact = 0;
    return;
  }
  const Totals last = m.totals;
  m.totals = {};
  flyShip(world);
  fireShots(world, last);
  growFlush(world);
  if (world.mode == Mode::swarm) {
    bringSwarm(world, last);
  } else if (world.mode == Mode::practice) {
    bringAsked(world, last);
  } else {
    bringWaves(world, last);
  }
  m.input = world.input;
}

}  // namespace gw::naive
