// Logic: the ship, its guns, what contact costs, what bits give back, and the end.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class logic : public ::testing::Test {
 protected:
  StageFixture fixture;
  const Rules& rules = fixture.rules();
  GameGlobals m = fixture.globals();
  TickScratch s{};

  logic() {
    m.tick = kLateTick;
    m.waveClock_ticks = 200;  // between the first wave and the second
    m.wave = 1;
  }

  // One tick with that input, in a field too busy for an early wave; m and s are what it leaves.
  void run(InputRecord input = {}) {
    m.totals.inView = rules.idle.fewerThan;
    fixture.setGlobals(m);
    fixture.setInput(input);
    cpu::logic(fixture.queue(), fixture.view());
    m = fixture.globals();
    s = fixture.scratch();
  }
  static uint64_t contactOf(uint32_t cost_us, uint32_t id) { return uint64_t(cost_us) << 32 | uint32_t(~id); }
  static constexpr InputRecord kFire = {0, 0, 0, kButtonFire}, kFlush = {0, 0, 0, kButtonFlush};
};

TEST_F(logic, the_ship_closes_its_share_of_the_gap_to_the_stick) {
  const float x = m.ship.x;
  run({kStickFull, 0, 0, 0});
  EXPECT_FLOAT_EQ(m.ship.velocity_x, 0.3f * 16.0f);
  EXPECT_FLOAT_EQ(m.ship.x, x + 4.8f / 60.0f);
  EXPECT_EQ(m.ship.previous_x, x);
  run({kStickFull, 0, 0, 0});
  EXPECT_FLOAT_EQ(m.ship.velocity_x, 4.8f + 0.3f * (16.0f - 4.8f));
}

TEST_F(logic, a_diagonal_stick_is_no_faster) {
  for (int i = 0; i < 60; ++i) run({kStickFull, int16_t(-kStickFull), 0, 0});
  EXPECT_NEAR(std::hypot(m.ship.velocity_x, m.ship.velocity_y), 16.0f, 1e-3f);
}

TEST_F(logic, walls_stop_the_ship) {
  for (const int side : {-1, 1}) {
    const auto stick = int16_t(side * kStickFull);
    for (int i = 0; i < 1200; ++i) run({stick, stick, 0, 0});
    EXPECT_EQ(m.ship.x, side < 0 ? 0.45f : fixture.limits().width_m - 0.45f);
    EXPECT_EQ(m.ship.y, side < 0 ? 0.45f : fixture.limits().height_m - 0.45f);
    EXPECT_EQ(m.ship.velocity_x, 0.0f);
    EXPECT_EQ(m.ship.velocity_y, 0.0f);
  }
}

TEST_F(logic, shots_follow_the_multiplier) {
  const struct {
    uint32_t tenths, shots, every, hits;
    float spread;
  } kLevels[] = {{10, 2, 6, 1, 0.0f},    {29, 2, 6, 1, 0.0f},    {30, 3, 6, 1, 0.09f},  {99, 3, 6, 1, 0.09f},
                 {100, 4, 5, 1, 0.08f},  {299, 4, 5, 1, 0.08f},  {300, 5, 4, 2, 0.08f}, {999, 5, 4, 2, 0.08f},
                 {1000, 7, 4, 3, 0.08f}, {99999, 7, 4, 3, 0.08f}};
  for (const auto& level : kLevels) {
    SCOPED_TRACE(level.tenths);
    m.multiplierTenths = level.tenths;
    m.ship.fire_ticks = 0;
    InputRecord input = kFire;
    input.aim = 16384;  // a quarter turn: upwards
    for (uint32_t tick = 0; tick < 2 * level.every; ++tick) {
      run(input);
      ASSERT_EQ(s.commandCount, tick % level.every == 0 ? 1u : 0u) << tick;
      EXPECT_EQ(s.shotSounds, s.commandCount);
      if (s.commandCount == 0) continue;
      const Command& c = s.commands[0];
      EXPECT_EQ(c.type, uint32_t(kTypeShot));
      EXPECT_EQ(c.count, level.shots);
      EXPECT_EQ(c.hits, level.hits);
      EXPECT_EQ(c.spread_rad, level.spread);
      EXPECT_NEAR(c.x, m.ship.x, 1e-5f);
      EXPECT_NEAR(c.y, m.ship.y + 0.55f, 1e-5f);
    }
  }
}

TEST_F(logic, nobody_fires_without_the_button) {
  run();
  EXPECT_EQ(s.commandCount, 0u);
  EXPECT_EQ(s.shotSounds, 0u);
}

TEST_F(logic, shots_that_do_not_fit_are_refused) {
  m.totals.occupied[kTypeShot] = kShotCapacity - 1;
  run(kFire);
  EXPECT_EQ(s.commands[0].count, 1u);
  EXPECT_EQ(m.refused, 1u);
  m.ship.fire_ticks = 0;
  m.totals.occupied[kTypeShot] = kShotCapacity;
  run(kFire);
  EXPECT_EQ(s.commandCount, 0u);
  EXPECT_EQ(m.refused, 3u);
}

TEST_F(logic, kills_score_by_the_multiplier_and_flushed_ones_their_bare_value) {
  m.multiplierTenths = 25;
  m.totals.kills[1] = 3;      // 25 each
  m.totals.bareKills[2] = 2;  // 150 each
  run();
  EXPECT_EQ(m.score, 3u * 25 * 25 / 10 + 2 * 150);
  EXPECT_EQ(m.kills, 5u);
  EXPECT_EQ(m.killsByType[1], 3u);
  EXPECT_EQ(m.killsByType[2], 2u);
  EXPECT_EQ(m.totals.kills[1], 0u);
  run();
  EXPECT_EQ(m.kills, 5u);
}

TEST_F(logic, contact_costs_time_and_makes_untouchable_for_ninety_ticks) {
  StageFixture& f = fixture;
  naive::World world = f.emptyWorld();
  world.globals = m;
  world.globals.totals.contact = contactOf(12000, 7);
  world.add(enemyAt(rules, 7, 2, 50.0f, 50.0f));
  f.put(world);
  f.setInput({});
  cpu::logic(f.queue(), f.view());
  m = f.globals();
  s = f.scratch();
  EXPECT_EQ(m.frameTime_us, 16667u + 12000u);
  EXPECT_EQ(m.blast, 1u);
  EXPECT_EQ(m.blastId, 7u);
  EXPECT_EQ(m.contacts, 1u);
  EXPECT_EQ(s.contactType, 2u);
  EXPECT_EQ(s.contactCost_us, 12000u);
  EXPECT_EQ(s.contactSounds, 1u);
  EXPECT_EQ(m.totals.contact, 0u);
  uint32_t untouchable = 0;
  for (; m.ship.untouchable_ticks > 0; ++untouchable) run();
  EXPECT_EQ(untouchable, 90u);
  EXPECT_EQ(m.blast, 0u);
  EXPECT_EQ(m.blastId, kNobody);
  EXPECT_EQ(m.contacts, 1u);
}

TEST_F(logic, bits_raise_the_multiplier_and_give_time_back_out_of_the_bank) {
  const uint32_t fill_us = rules.budget.bankFill_us, most_us = rules.budget.bankMax_us;
  m.frameTime_us = 30000;
  m.bank_us = 100;
  m.totals.bitsTaken = 2;
  run();
  EXPECT_EQ(m.multiplierTenths, 12u);
  EXPECT_EQ(m.bitsTaken, 2u);
  EXPECT_EQ(m.frameTime_us, 30000u - 80);
  EXPECT_EQ(m.bank_us, 100 + fill_us - 80);
  m.totals.bitsTaken = 20;  // more than the bank holds
  run();
  EXPECT_EQ(m.frameTime_us, 30000u - 80 - (20 + 2 * fill_us));
  EXPECT_EQ(m.bank_us, 0u);
  for (uint32_t i = 0; i < most_us / fill_us + 1; ++i) run();
  EXPECT_EQ(m.bank_us, most_us);
  m.frameTime_us = rules.budget.start_us + 5;
  m.totals.bitsTaken = 3;
  run();
  EXPECT_EQ(m.frameTime_us, rules.budget.start_us);  // never under 60 FPS' worth
  EXPECT_EQ(m.bank_us, most_us - 5);
}

TEST_F(logic, the_score_brings_flushes_up_to_five) {
  m.flushes = 4;
  m.score = 99'990;
  m.totals.kills[0] = 1;
  run();
  EXPECT_EQ(m.score, 100'000u);
  EXPECT_EQ(m.flushes, 5u);
  EXPECT_EQ(m.flushScores, 1u);
  m.score = 1'000'000;  // two thresholds at once, none fits
  run();
  EXPECT_EQ(m.flushes, 5u);
  EXPECT_EQ(m.flushScores, 3u);
  m.flushes = 1;
  m.score = 2'999'999;
  run();
  EXPECT_EQ(m.flushes, 1u);
  m.score = 3'000'000;
  run();
  EXPECT_EQ(m.flushes, 2u);
}

TEST_F(logic, the_flush_goes_off_at_the_press_and_its_ring_grows_to_its_reach) {
  const float x = m.ship.x;
  run(kFlush);
  EXPECT_EQ(m.flushes, 2u);
  EXPECT_EQ(s.flushSounds, 1u);
  EXPECT_EQ(m.ship.untouchable_ticks, 60u);
  EXPECT_FLOAT_EQ(m.flushRadius_m, 80.0f / 60.0f);
  float widest = 0.0f;
  uint32_t ticks = 1;
  for (; m.flushRadius_m > 0.0f; ++ticks) {
    widest = m.flushRadius_m;
    run(ticks % 2 ? kFlush : InputRecord{kStickFull, 0, 0, kButtonFlush});  // held: nothing more happens
    EXPECT_EQ(s.flushSounds, 0u);
  }
  EXPECT_EQ(ticks, 28u);
  EXPECT_NEAR(widest, 36.0f, 1e-4f);
  EXPECT_EQ(m.flushes, 2u);
  EXPECT_EQ(m.flush_x, x);  // it stays where it went off
  run();
  run(kFlush);
  EXPECT_EQ(m.flushes, 1u);
  run();
  run(kFlush);  // pressed again while one runs
  EXPECT_EQ(m.flushes, 1u);
  m.flushRadius_m = 0.0f;
  m.flushes = 0;
  run();
  run(kFlush);  // none left
  EXPECT_EQ(m.flushRadius_m, 0.0f);
}

TEST_F(logic, under_twelve_frames_a_second_it_is_over) {
  m.frameTime_us = rules.budget.limit_us;  // exactly at it is not
  run();
  EXPECT_EQ(m.over, 0u);
  m.frameTime_us = rules.budget.limit_us + 1;
  const Ship ship = m.ship;
  run({kStickFull, 0, 0, kButtonFire});
  EXPECT_EQ(m.over, 1u);
  EXPECT_EQ(m.tick, kLateTick + 2);
  EXPECT_EQ(s.overSounds, 1u);
  EXPECT_EQ(s.commandCount, 0u);
  EXPECT_EQ(m.ship.x, ship.x);
  const GameGlobals end = m;
  run({kStickFull, 0, 0, uint16_t(kButtonFire | kButtonFlush)});
  EXPECT_TRUE(same(m, end));
  EXPECT_EQ(s.overSounds, 0u);
}

TEST_F(logic, the_peak_counts_the_living_alone) {
  m.totals.occupied[0] = 40;
  m.totals.occupied[2] = 2;
  m.totals.dying = 5;
  m.totals.occupied[kTypeShot] = 100;
  run();
  EXPECT_EQ(m.peakEnemies, 37u);
}

}  // namespace
}  // namespace gw::test
