// Waves: the timetable, the idle rule, the endless waves, and what does not fit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class waves : public ::testing::Test {
 protected:
  StageFixture fixture{stageConfig(8192)};
  const Rules& rules = fixture.rules();
  GameGlobals m = fixture.globals();
  TickScratch s{};

  // Totals of a field that is busy, so that no wave comes early.
  void busy() {
    m.totals = {};
    m.totals.inView = 8;
    m.totals.occupied[0] = 8;
  }
  void run() {
    fixture.setGlobals(m);
    fixture.setInput({});
    cpu::logic(fixture.queue(), fixture.view());
    m = fixture.globals();
    s = fixture.scratch();
  }
  uint32_t ordered() const {
    uint32_t sum = 0;
    for (uint32_t c = 0; c < s.commandCount; ++c) sum += s.commands[c].count;
    return sum;
  }
};

TEST_F(waves, come_at_the_times_of_the_table_with_its_groups) {
  uint32_t started = 0;
  for (uint32_t tick = 0; tick < rules.endless.from_ticks; ++tick) {
    busy();
    run();
    const bool due = started < rules.waveCount && rules.waves[started].at_ticks == tick;
    ASSERT_EQ(s.waveSounds, due ? 1u : 0u) << tick;
    if (!due) {
      ASSERT_EQ(s.commandCount, 0u) << tick;
      continue;
    }
    const Wave& wave = rules.waves[started++];
    ASSERT_EQ(s.commandCount, wave.groupCount);
    uint32_t births = 0;
    for (uint32_t g = 0; g < wave.groupCount; ++g) {
      EXPECT_EQ(s.commands[g].type, wave.groups[g].type);
      EXPECT_EQ(s.commands[g].count, wave.groups[g].count);
      EXPECT_EQ(s.commands[g].pattern, wave.groups[g].pattern);
      EXPECT_EQ(s.commands[g].firstBirth, births);
      EXPECT_EQ(s.commands[g].x, m.ship.x);
      births += wave.groups[g].count;
    }
    EXPECT_EQ(s.births, births);
    EXPECT_EQ(m.wave, started);
  }
  EXPECT_EQ(started, rules.waveCount);
  EXPECT_EQ(m.score, 0u);
}

TEST_F(waves, endless_ones_follow_with_growing_points) {
  m.wave = rules.waveCount;
  m.tick = m.waveClock_ticks = rules.endless.from_ticks;
  double points = rules.endless.points * double(rules.endless.growth);  // the rules count waves from 1
  double pace = 1.0;
  std::set<uint32_t> types;
  std::set<Pattern> patterns;
  for (uint32_t k = 0; k < 24; ++k) {
    SCOPED_TRACE(k);
    for (uint32_t tick = 0; tick < rules.endless.every_ticks; ++tick) {
      busy();
      run();
      ASSERT_EQ(s.waveSounds, tick == 0 ? 1u : 0u) << tick;
      if (tick > 0) continue;
      pace = std::min(pace * double(rules.endless.paceGrowth), double(rules.endless.paceMost));
      EXPECT_NEAR(double(m.pace), pace, 1.0e-5);
      const uint32_t groups = (k + 1) % 3 + 1;
      ASSERT_EQ(s.commandCount, groups);
      for (uint32_t g = 0; g < groups; ++g) {
        const Command& c = s.commands[g];
        ASSERT_LT(c.type, rules.enemyTypeCount);
        types.insert(c.type);
        patterns.insert(c.pattern);
        EXPECT_NEAR(double(c.count), points / groups / double(rules.endless.price[c.type]), 1.01);
      }
    }
    points *= double(rules.endless.growth);
  }
  EXPECT_EQ(types.size(), rules.enemyTypeCount);
  EXPECT_GE(patterns.size(), 5u);
}

TEST_F(waves, a_field_nearly_empty_brings_the_next_one_soon_and_pays) {
  m.wave = 3;
  m.waveClock_ticks = rules.waves[3].at_ticks - 300;
  m.tick = 500;
  m.multiplierTenths = 37;
  m.totals = {};
  const auto few = [&] { m.totals.inView = m.totals.coming = 7; };  // fewer than eight
  few();
  for (uint32_t tick = 1; tick < rules.idle.wait_ticks; ++tick) {
    few();
    run();
    ASSERT_EQ(s.waveSounds, 0u) << tick;
  }
  few();
  run();
  EXPECT_EQ(s.waveSounds, 1u);
  EXPECT_EQ(m.wave, 4u);
  EXPECT_EQ(m.score, 50u * 37 * (300 - (rules.idle.wait_ticks - 1)) / 600);  // 50 x multiplier per second saved
  EXPECT_EQ(m.idle_ticks, 0u);
}

TEST_F(waves, enough_that_come_or_are_in_view_reset_the_wait) {
  m.wave = 3;
  m.waveClock_ticks = rules.waves[3].at_ticks - 400;
  m.tick = 500;
  ASSERT_GT(rules.idle.wait_ticks, 25u);
  for (uint32_t tick = 0; tick < 390; ++tick) {
    m.totals.inView = tick % 50 == 25 ? 8 : 0;
    m.totals.coming = tick % 50 == 0 ? 8 : 0;
    run();
    ASSERT_EQ(s.waveSounds, 0u) << tick;
    ASSERT_EQ(m.idle_ticks, m.totals.occupied[0] + (tick % 50 == 0 || tick % 50 == 25 ? 0u
                                                    : tick % 50 < 25                  ? tick % 50
                                                                                      : tick % 50 - 25));
  }
  EXPECT_EQ(m.score, 0u);
}

TEST_F(waves, what_does_not_fit_is_refused_and_counted) {
  busy();
  m.totals.occupied[1] = 8192 - 8 - 10;  // room for ten
  run();
  EXPECT_EQ(ordered(), 10u);
  EXPECT_EQ(m.refused, rules.waves[0].groups[0].count - 10);
}

// The dying still hold their ids until spawn frees them, so they count against the room.
TEST_F(waves, a_full_field_takes_nobody) {
  busy();
  m.totals.occupied[0] = 8192;
  m.totals.dying = 20;
  run();
  EXPECT_EQ(s.commandCount, 0u);
  EXPECT_EQ(m.refused, rules.waves[0].groups[0].count);
}

TEST_F(waves, are_the_naive_version_over_ten_minutes_of_chance) {
  naive::World world = fixture.emptyWorld();
  Dice dice(1);
  for (uint32_t tick = 0; tick < 36000 && !world.globals.over; ++tick) {
    Totals& t = world.globals.totals;
    t.inView = dice.below(4000) < 3 ? 0 : dice.below(40);
    t.coming = dice.below(4000) < 3 ? 9 : dice.below(9);
    t.occupied[0] = dice.below(8300);
    t.occupied[kTypeShot] = dice.below(1100);
    t.dying = t.occupied[0] / 50;
    t.kills[dice.below(3)] = dice.below(20);
    t.bareKills[dice.below(3)] = dice.below(3);
    t.bitsTaken = dice.below(6);
    if (dice.below(700) == 0) t.contact = uint64_t(1000 + dice.below(1000)) << 32 | uint32_t(~dice.below(5000));
    const auto stick = [&] { return int16_t(int(dice.below(65535)) - 32767); };
    world.input = {stick(), stick(), uint16_t(dice.below(65536)), uint16_t(dice.below(4))};
    fixture.setGlobals(world.globals);
    fixture.setInput(world.input);
    cpu::logic(fixture.queue(), fixture.view());
    naive::logic(world);
    ASSERT_TRUE(same(fixture.globals(), world.globals)) << "tick " << tick;
    const TickScratch is = fixture.scratch();
    ASSERT_EQ(is.commandCount, world.commands.size()) << "tick " << tick;
    for (uint32_t c = 0; c < is.commandCount; ++c) {
      ASSERT_EQ(0, std::memcmp(&is.commands[c], &world.commands[c], sizeof(Command))) << "tick " << tick;
    }
  }
  EXPECT_GT(world.globals.tick, 10000u);
}

}  // namespace
}  // namespace gw::test
