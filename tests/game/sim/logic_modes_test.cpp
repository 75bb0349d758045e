// What the modes do otherwise than the arcade: the deadline's clock, the swarm's one wave and its end,
// practice on request.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/sim/entity_flags.h"
#include "tests/game/sim/game_runs.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

SimulationConfig modeConfig(Mode mode, uint32_t enemies = 1000) {
  SimulationConfig config = stageConfig(enemies);
  config.mode = mode;
  return config;
}

// Logic alone.
class Logic {
 public:
  explicit Logic(Mode mode, uint32_t enemies = 1000) : fixture(modeConfig(mode, enemies)), m(fixture.globals()) {}

  void run(InputRecord input = {}) {
    fixture.setGlobals(m);
    fixture.setInput(input);
    cpu::logic(fixture.queue(), fixture.view());
    m = fixture.globals();
    s = fixture.scratch();
  }
  void busy(uint32_t enemies) {
    m.totals = {};
    m.totals.inView = enemies;
    m.totals.occupied[0] = enemies;
  }
  void touched(uint32_t cost_us) { m.totals.contact = uint64_t(cost_us) << 32 | 0xFFFFFFF0u; }
  uint32_t ordered() const {
    uint32_t sum = 0;
    for (uint32_t c = 0; c < s.commandCount; ++c) sum += s.commands[c].count;
    return sum;
  }

  StageFixture fixture;
  GameGlobals m;
  TickScratch s{};
};

TEST(deadline, the_clock_runs_out_after_its_time_and_not_before) {
  Logic logic(Mode::deadline);
  const uint32_t ticks = gameRules().deadline.clock_ticks;
  ASSERT_EQ(ticks, 180u * 60u);
  logic.m.clock_ticks = 3;
  for (uint32_t t = 0; t < 3; ++t) {
    logic.busy(20);
    logic.run();
    ASSERT_EQ(logic.m.over, 0u) << t;
  }
  EXPECT_EQ(logic.m.clock_ticks, 0u);
  logic.busy(20);
  logic.run();
  EXPECT_EQ(logic.m.over, uint32_t(Ending::timeUp));
  EXPECT_EQ(logic.s.overSounds, 1u);
}

TEST(deadline, a_contact_costs_the_clock_and_no_frame_time) {
  Logic logic(Mode::deadline);
  const uint32_t before = logic.m.clock_ticks, frame_us = logic.m.frameTime_us;
  ASSERT_EQ(before, gameRules().deadline.clock_ticks);
  logic.busy(20);
  logic.touched(5000);
  logic.run();
  EXPECT_EQ(logic.m.clock_ticks, before - 90 - 1);  // 5 ms at 0.3 s each, and this tick
  EXPECT_EQ(logic.m.frameTime_us, frame_us);
  EXPECT_EQ(logic.m.blast, uint32_t(kBlastNear));
  logic.m.clock_ticks = 10;  // more than is left: it ends now, and wraps round nothing
  logic.busy(20);
  logic.touched(12000);
  logic.run();
  EXPECT_EQ(logic.m.over, uint32_t(Ending::timeUp));
}

TEST(deadline, the_timetable_runs_twice_as_fast) {
  Logic logic(Mode::deadline);
  const Rules& rules = gameRules();
  uint32_t started = 0;
  for (uint32_t tick = 0; tick < 1500; ++tick) {
    logic.busy(20);
    logic.run();
    const bool due = started < rules.waveCount && rules.waves[started].at_ticks <= 2 * tick;
    ASSERT_EQ(logic.s.waveSounds, due ? 1u : 0u) << tick;
    if (due) ++started;
  }
  EXPECT_GE(started, 6u);
}

TEST(swarm, all_come_in_the_first_tick_in_the_mix_and_nobody_later) {
  Logic logic(Mode::swarm, 5000);
  const Rules& rules = gameRules();
  EXPECT_EQ(logic.m.multiplierTenths, rules.swarm.multiplierTenths);
  logic.run();
  EXPECT_EQ(logic.ordered(), 5000u);
  ASSERT_EQ(logic.s.commandCount, rules.enemyTypeCount);
  double sum = 0;
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) sum += rules.endless.chance_percent[t] / rules.endless.price[t];
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) {
    EXPECT_EQ(logic.s.commands[t].type, t);
    EXPECT_NEAR(logic.s.commands[t].count, 5000 * rules.endless.chance_percent[t] / rules.endless.price[t] / sum, 8.0);
  }
  for (uint32_t tick = 1; tick < 2000; ++tick) {
    logic.busy(5000);
    logic.run();
    ASSERT_EQ(logic.s.commandCount, 0u) << tick;
  }
}

TEST(swarm, is_born_beyond_its_clearance_and_spread_over_the_world) {
  const SimulationConfig config = modeConfig(Mode::swarm, 3000);
  const auto simulation = cpu::makeSimulation(config);
  simulation->tick({});
  const TickReport report = simulation->report();
  EXPECT_EQ(report.enemies, 3000u);
  EXPECT_EQ(report.refused, 0u);
  uint32_t quarters[4] = {};
  for (const EntityRecord& e : simulation->snapshot().entities) {
    ASSERT_GE(std::hypot(e.x - report.ship_x, e.y - report.ship_y), config.rules.swarm.clearance_m);
    ++quarters[(e.x > report.ship_x ? 1 : 0) + (e.y > report.ship_y ? 2 : 0)];
  }
  for (const uint32_t quarter : quarters) EXPECT_NEAR(quarter, 750.0, 120.0);  // 5 standard deviations
}

TEST(swarm, the_last_hundredth_attacks_and_an_empty_field_is_cleared) {
  Logic logic(Mode::swarm, 1000);
  logic.run();
  logic.busy(11);
  logic.run();
  EXPECT_EQ(logic.m.allAttack, 0u);
  logic.busy(10);
  logic.run();
  EXPECT_EQ(logic.m.allAttack, 1u);
  logic.busy(2);
  logic.m.totals.dying = 1;
  logic.run();
  EXPECT_EQ(logic.m.over, 0u);
  logic.busy(2);
  logic.m.totals.dying = 2;
  logic.run();
  EXPECT_EQ(logic.m.over, uint32_t(Ending::cleared));
}

TEST(swarm, whoever_is_told_to_attack_does_from_anywhere) {
  StageFixture fixture(modeConfig(Mode::swarm, 256));
  naive::World world = fixture.emptyWorld();
  world.globals.tick = kLateTick;
  world.globals.allAttack = 1;
  for (uint32_t type = 0; type < fixture.rules().enemyTypeCount; ++type) {
    world.add(enemyAt(fixture.rules(), type, type, 4.0f, 4.0f + 12.0f * float(type)));  // out of every enemy's sight
  }
  fixture.begin(world);
  cpu::think(fixture.queue(), fixture.view());
  for (const EntityRecord& e : fixture.entities(true, false)) EXPECT_EQ(e.state, uint32_t(State::attacking)) << e.type;
}

InputRecord asked(uint32_t type, uint32_t number) {
  InputRecord input;
  input.buttons = uint16_t(kButtonSpawn | type << kSpawnTypeShift | number << kSpawnCountShift);
  return input;
}

TEST(practice, each_press_brings_what_was_asked_for_and_nothing_else_comes) {
  Logic logic(Mode::practice);
  for (uint32_t tick = 0; tick < 1200; ++tick) {
    logic.run();
    ASSERT_EQ(logic.s.commandCount, 0u) << tick;
  }
  for (uint32_t number = 0; number < std::size(kPracticeCounts); ++number) {
    logic.m.totals = {};
    logic.run(asked(number % 7, number));
    EXPECT_EQ(logic.ordered(), std::min(kPracticeCounts[number], 1000u));
    ASSERT_EQ(logic.s.commandCount, 1u);
    EXPECT_EQ(logic.s.commands[0].type, number % 7);
    logic.run(asked(number % 7, number));  // held
    EXPECT_EQ(logic.s.commandCount, 0u);
    logic.run();
  }
  EXPECT_EQ(logic.m.refused, 1000u);  // of the 2,000 that do not fit
}

TEST(practice, what_no_table_knows_is_not_brought) {
  Logic logic(Mode::practice);
  for (uint32_t number = std::size(kPracticeCounts); number <= kSpawnCountMask; ++number) {
    logic.run(asked(0, number));
    EXPECT_EQ(logic.s.commandCount, 0u);
    logic.run();
  }
  logic.run(asked(7, 0));  // seven types: 0 to 6
  EXPECT_EQ(logic.s.commandCount, 0u);
}

TEST(practice, never_ends_however_much_touches) {
  Logic logic(Mode::practice);
  for (int contact = 0; contact < 40; ++contact) {
    logic.touched(12000);
    logic.run();
    ASSERT_EQ(logic.m.over, 0u);
    logic.m.totals = {};
  }
  EXPECT_EQ(logic.m.frameTime_us, gameRules().budget.limit_us);
}

TEST(practice, clearing_ends_all_that_live_without_score) {
  const auto simulation = cpu::makeSimulation(modeConfig(Mode::practice));
  play(*simulation, 1);
  play(*simulation, 1, {asked(2, 6)});
  const TickReport before = play(*simulation, 60).back();
  EXPECT_EQ(before.enemies, 100u);
  InputRecord clear;
  clear.buttons = kButtonClear;
  play(*simulation, 1, {clear});
  const TickReport after = play(*simulation, 4).back();
  EXPECT_EQ(after.enemies, 0u);
  EXPECT_EQ(after.score, before.score);
  EXPECT_EQ(after.kills, before.kills);
}

TEST(modes, the_arcade_ignores_the_buttons_of_practice) {
  Logic logic(Mode::arcade);
  logic.run();
  logic.busy(20);
  logic.run(asked(1, 5));
  EXPECT_EQ(logic.s.commandCount, 0u);
  logic.busy(20);
  InputRecord clear;
  clear.buttons = kButtonClear;
  logic.run(clear);
  EXPECT_EQ(logic.m.blast, uint32_t(kBlastNone));
}

}  // namespace
}  // namespace gw::test
