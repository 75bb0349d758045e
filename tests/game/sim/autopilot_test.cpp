// Autopilot: the host's record is taken as it is; bots do what the rules say of them on scenes made by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kTriangle = 0, kDecisionTick = 1008;  // both bots decide: a multiple of 18 and of 4

class autopilot : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  const float x = world.globals.ship.x, y = world.globals.ship.y;

  autopilot() { world.globals.tick = kDecisionTick; }

  void add(uint32_t type, float at_x, float at_y, float velocity_x = 0.0f, float velocity_y = 0.0f) {
    EntityRecord e = type == kTypeBit ? bitAt(rules, next, at_x, at_y) : enemyAt(rules, next, type, at_x, at_y);
    e.velocity_x = velocity_x;
    e.velocity_y = velocity_y;
    e.previous_x = at_x - velocity_x * kTick_s;
    e.previous_y = at_y - velocity_y * kTick_s;
    world.add(e);
    ++next;
  }
  InputRecord run(Autopilot who) {
    fixture.put(world);
    cpu::autopilot(fixture.queue(), fixture.view(), who);
    return fixture.scratch().input;
  }
  // The aim's distance from that direction, in degrees, -180 to 180.
  static double offBy(InputRecord input, double angle_rad) {
    const double off = double(input.aim) / 65536.0 * 360.0 - angle_rad * 57.29577951308232;
    return std::remainder(off, 360.0);
  }

  uint32_t next = 0;
};

TEST_F(autopilot, none_leaves_the_hosts_record_as_it_is) {
  TickScratch s = fixture.scratch();
  s.input = {int16_t(700), int16_t(-6), uint16_t(42), uint16_t(3)};
  fixture.setScratch(s);
  cpu::autopilot(fixture.queue(), fixture.view(), Autopilot::none);
  EXPECT_EQ(fixture.scratch().input, s.input);
}

TEST_F(autopilot, the_novice_aims_at_the_nearest_within_fifteen_degrees) {
  add(kTriangle, x - 15.0f, y + 15.0f);
  add(kTriangle, x + 25.0f, y);
  double most = 0.0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    world.globals.seed = seed;
    const InputRecord input = run(Autopilot::novice);
    EXPECT_EQ(input.buttons, kButtonFire);
    most = std::max(most, std::fabs(offBy(input, 3.0 * 0.7853981633974483)));
  }
  EXPECT_LE(most, 15.01);
  EXPECT_GT(most, 10.0);
}

TEST_F(autopilot, the_novice_sees_where_things_were_eighteen_ticks_ago) {
  add(kTriangle, x, y + 20.0f, 20.0f, 0.0f);  // 6 m to the left then
  double sum = 0.0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    world.globals.seed = seed;
    sum += offBy(run(Autopilot::novice), std::atan2(20.0, -6.0));
  }
  EXPECT_NEAR(sum / 200.0, 0.0, 2.5);  // the wobble cancels; seen as it is now would be 16.7 off
}

TEST_F(autopilot, the_novice_flees_then_fetches_then_goes_to_the_middle) {
  world.globals.ship.x = world.globals.ship.previous_x = 50.0f;
  add(kTypeBit, 50.0f, y + 8.0f, 0.0f, 0.0f);
  InputRecord input = run(Autopilot::novice);
  EXPECT_EQ(input.move_x, 0);
  EXPECT_EQ(input.move_y, kStickFull);
  EXPECT_EQ(input.buttons, 0);  // no target
  add(kTriangle, 50.0f, y + 6.9f);
  EXPECT_EQ(run(Autopilot::novice).move_y, -kStickFull);
  world.entities.clear();
  add(kTypeBit, 50.0f, y + 10.1f, 0.0f, 0.0f);
  add(kTriangle, 50.0f, y + 7.1f);
  input = run(Autopilot::novice);
  EXPECT_EQ(input.move_x, kStickFull);
  EXPECT_NEAR(input.move_y, 0, 1);
}

TEST_F(autopilot, bots_hold_a_decision_until_the_next) {
  for (const Autopilot who : {Autopilot::novice, Autopilot::expert}) {
    const uint32_t every = who == Autopilot::novice ? 18 : 4;
    world.entities.clear();
    add(kTriangle, x + 6.0f, y);
    world.globals.tick = kDecisionTick;
    const InputRecord held = run(who);
    world.globals.input = held;  // as logic keeps it
    world.entities.clear();
    add(kTriangle, x - 6.0f, y);
    for (uint32_t tick = 1; tick < every; ++tick) {
      world.globals.tick = kDecisionTick + tick;
      EXPECT_EQ(run(who), held) << tick;
    }
    world.globals.tick = kDecisionTick + every;
    EXPECT_NE(run(who).aim >> 14, held.aim >> 14);
  }
}

TEST_F(autopilot, bots_see_nobody_out_of_view_or_dead) {
  add(kTriangle, x + 36.5f, y);
  add(kTriangle, x, y + 20.5f);
  add(kTriangle, x + 5.0f, y);
  world.entities.back().state = uint32_t(State::dead);
  EXPECT_EQ(run(Autopilot::novice).buttons, 0);
  EXPECT_EQ(run(Autopilot::expert).buttons, 0);
}

TEST_F(autopilot, the_novice_flushes_half_of_the_time_when_crowded) {
  for (uint32_t i = 0; i < 31; ++i) add(kTriangle, x + 3.0f * std::cos(float(i)), y + 3.0f * std::sin(float(i)));
  const auto flushes = [&] {
    uint32_t count = 0;
    for (uint64_t seed = 0; seed < 200; ++seed) {
      world.globals.seed = seed;
      count += (run(Autopilot::novice).buttons & kButtonFlush) != 0;
    }
    return count;
  };
  EXPECT_NEAR(double(flushes()), 100.0, 30.0);
  world.entities.pop_back();
  EXPECT_EQ(flushes(), 0u);
  world.globals.frameTime_us = 60001;
  EXPECT_GT(flushes(), 60u);
  world.entities.resize(4);
  EXPECT_EQ(flushes(), 0u);
}

TEST_F(autopilot, the_expert_aims_with_lead_within_two_degrees) {
  add(kTriangle, x + 12.0f, y, 0.0f, 12.0f);
  // Seen 0.1 s late, then followed over that time and the shot's way.
  const double lead = 12.06 / 45.0 + 0.1, wanted = std::atan2(-1.2 + 12.0 * lead, 12.0);
  for (uint64_t seed = 0; seed < 30; ++seed) {
    world.globals.seed = seed;
    EXPECT_NEAR(offBy(run(Autopilot::expert), wanted), 0.0, 2.2);
  }
}

TEST_F(autopilot, the_expert_leaves_the_way_of_what_comes) {
  add(kTriangle, x + 5.0f, y, -10.0f, 0.0f);
  const InputRecord input = run(Autopilot::expert);
  EXPECT_GT(std::abs(int(input.move_x)) + std::abs(int(input.move_y)), 30000);
  EXPECT_LE(input.move_x, 0);
}

TEST_F(autopilot, the_expert_flushes_at_fourteen) {
  for (uint32_t i = 0; i < 14; ++i) add(kTriangle, x + 4.5f * std::cos(float(i)), y + 4.5f * std::sin(float(i)));
  EXPECT_TRUE(run(Autopilot::expert).buttons & kButtonFlush);
}

TEST_F(autopilot, bots_decide_the_same_with_either_search) {
  SimulationConfig config = stageConfig();
  config.broadPhase = BroadPhase::bruteForce;
  StageFixture brute(config);
  for (uint32_t seed = 0; seed < 20; ++seed) {
    world = fixture.emptyWorld();
    world.globals.tick = kDecisionTick;
    Dice dice(seed);
    addCrowd(world, 200, 60, 60, 30.0f, dice);
    for (const Autopilot who : {Autopilot::novice, Autopilot::expert}) {
      const InputRecord wanted = run(who);
      brute.put(world);
      cpu::autopilot(brute.queue(), brute.view(), who);
      EXPECT_EQ(brute.scratch().input, wanted);
    }
  }
}

}  // namespace
}  // namespace gw::test
