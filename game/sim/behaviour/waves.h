// Which enemies appear when, as logic orders it: the timetable and the endless waves after it (arcade,
// deadline), all at once (swarm), or what the player asks for (practice).
#pragma once

#include "game/sim/state.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"

namespace gw::GW_DEVICE {

// Appends the command, cut to what fits; the rest is counted as refused. Returns how many were accepted.
GW_FN uint32_t queueCommand(GameGlobals& m, TickScratch& s, Command command, uint32_t room) {
  const uint32_t accepted = s.commandCount < kMaxCommands ? smaller(command.count, room) : 0;
  m.refused += command.count - accepted;
  if (accepted == 0) return 0;
  command.count = accepted;
  command.firstBirth = s.births;
  s.births += accepted;
  s.commands[s.commandCount++] = command;
  return accepted;
}

struct Waves {
  GameGlobals& m;
  TickScratch& s;
  const Tables& tables;
  const Totals& last;
  uint32_t alive = 0, room = 0;

  GW_MEMBER void run() {
    for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) alive += last.occupied[t];
    room = tables.limits.enemies - smaller(tables.limits.enemies, alive);
    switch (tables.mode) {
      case Mode::arcade:
        return timetable(1);
      case Mode::deadline:
        return timetable(tables.rules.deadline.waveRate);
      case Mode::swarm:
        return swarm();
      case Mode::practice:
        return practice();
    }
  }

 private:
  // `rate` ticks of the timetable per tick.
  GW_MEMBER void timetable(uint32_t rate) {
    const Rules& r = tables.rules;
    const uint32_t next_ticks =
        m.wave < r.waveCount ? r.waves[m.wave].at_ticks : r.endless.from_ticks + m.endless * r.endless.every_ticks;
    // A world that is nearly empty brings the next wave early, and pays for the time saved.
    const bool quiet = m.tick > 1 && last.inView < r.idle.fewerThan && last.coming < r.idle.fewerThan;
    m.idle_ticks = quiet ? m.idle_ticks + 1 : 0;
    if (m.idle_ticks >= r.idle.wait_ticks && next_ticks > m.waveClock_ticks) {
      const uint32_t saved_ticks = (next_ticks - m.waveClock_ticks) / rate;
      m.score += uint64_t(r.idle.pays) * m.multiplierTenths * saved_ticks / (10 * kTicksPerSecond);
      m.waveClock_ticks = next_ticks;
      m.idle_ticks = 0;
    }
    if (m.waveClock_ticks >= next_ticks) {
      if (m.wave < r.waveCount) {
        const Wave& wave = r.waves[m.wave++];
        for (uint32_t g = 0; g < wave.groupCount; ++g) {
          group(wave.groups[g].type, wave.groups[g].count, wave.groups[g].pattern);
        }
      } else {
        endlessWave();
      }
      s.waveSounds = 1;
    }
    m.waveClock_ticks += rate;
  }

  GW_MEMBER void endlessWave() {
    const Rules& r = tables.rules;
    ++m.endless;  // the k of the rules, from 1
    m.endlessPoints = smaller(m.endlessPoints * r.endless.growth, 1.0e6f);
    m.pace = smaller(m.pace * r.endless.paceGrowth, r.endless.paceMost);
    const uint32_t groups = m.endless % 3 + 1;
    uint32_t chances = 0;
    for (uint32_t t = 0; t < r.enemyTypeCount; ++t) chances += r.endless.chance_percent[t];
    for (uint32_t g = 0; g < groups; ++g) {
      const Uint4 dice = philox(m.seed, {m.tick, g, kPurposeEndless, 0});
      uint32_t pick = chances ? dice.x % chances : 0, type = 0;
      while (type + 1 < r.enemyTypeCount && pick >= r.endless.chance_percent[type]) {
        pick -= r.endless.chance_percent[type++];
      }
      const float count = clamp(m.endlessPoints / (float(groups) * r.endless.price[type]), 1.0f, 1.0e6f);
      group(type, uint32_t(count), Pattern(dice.y % uint32_t(Pattern::count)));
    }
  }

  // All that fit, in the first tick: as many of each type as the endless waves would bring in the long run.
  // What rounding leaves over is of the first type.
  GW_MEMBER void swarm() {
    const Rules& r = tables.rules;
    const uint32_t living = alive - smaller(alive, last.dying);
    if (m.tick == 1) {
      float weights = 0.0f;
      for (uint32_t t = 0; t < r.enemyTypeCount; ++t) weights += weightOf(t);
      uint32_t counts[kMaxEnemyTypes] = {}, sum = 0;
      for (uint32_t t = 0; t < r.enemyTypeCount; ++t) {
        counts[t] = smaller(uint32_t(clamp(float(room) * (weightOf(t) / weights), 0.0f, 2.0e9f)), room - sum);
        sum += counts[t];
      }
      counts[0] += room - sum;
      for (uint32_t t = 0; t < r.enemyTypeCount; ++t) {
        if (counts[t] > 0) group(t, counts[t], Pattern::rain);
      }
      s.waveSounds = 1;
      m.wave = 1;
    } else if (float(living) <= float(tables.limits.enemies) * r.swarm.attackShare) {
      m.allAttack = 1;
    }
  }

  // Signed, because g++ turns a run of unsigned numbers into floats by way of an FMA (exact, but gate_vfmadd
  // cannot tell).
  GW_MEMBER float weightOf(uint32_t type) const {
    return float(int32_t(tables.rules.endless.chance_percent[type])) / tables.rules.endless.price[type];
  }

  // Each request takes the next pattern, so that all of them can be practised.
  GW_MEMBER void practice() {
    const uint32_t buttons = s.input.buttons, pressed = buttons & ~uint32_t(m.input.buttons);
    constexpr uint32_t kCounts = sizeof kPracticeCounts / sizeof kPracticeCounts[0];
    if (pressed & kButtonClear) m.blast = kBlastAll;
    const uint32_t type = buttons >> kSpawnTypeShift & kSpawnTypeMask;
    const uint32_t number = buttons >> kSpawnCountShift & kSpawnCountMask;
    if (!(pressed & kButtonSpawn) || type >= tables.rules.enemyTypeCount || number >= kCounts) return;
    group(type, practiceCountOf(number), Pattern(m.wave++ % uint32_t(Pattern::count)));
    s.waveSounds = 1;
  }

  // kPracticeCounts[number], which device code cannot index.
  GW_MEMBER static uint32_t practiceCountOf(uint32_t number) {
    uint32_t count = number % 3 == 0 ? 1 : number % 3 == 1 ? 2 : 5;
    for (uint32_t tens = number / 3; tens > 0; --tens) count *= 10;
    return count;
  }

  GW_MEMBER void group(uint32_t type, uint32_t count, Pattern pattern) {
    Command born;
    born.type = type;
    born.count = count;
    born.pattern = pattern;
    born.x = m.ship.x;
    born.y = m.ship.y;
    born.angle_rad = unitFloat(philox(m.seed, {m.tick, s.commandCount, kPurposeCommand, 0}).x) * kTwoPi;
    room -= queueCommand(m, s, born, room);
  }
};

}  // namespace gw::GW_DEVICE
