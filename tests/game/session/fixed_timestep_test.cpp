#include "game/session/fixed_timestep.h"

#include <gtest/gtest.h>

namespace gw {
namespace {

constexpr double kTick = 1.0 / 60;

uint32_t ticksOf(FixedTimestep& timestep, double now) {
  timestep.frame(now);
  uint32_t ticks = 0;
  while (timestep.due()) ++ticks;
  return ticks;
}

TEST(FixedTimestepTest, SixtyTicksASecondAtEveryFrameRate) {
  for (const double rate : {24.0, 30.0, 59.94, 60.0, 75.0, 144.0, 240.0, 1000.0}) {
    FixedTimestep timestep;
    uint32_t ticks = 0;
    for (int frame = 0; frame <= int(10 * rate); ++frame) ticks += ticksOf(timestep, 5 + frame / rate);
    EXPECT_NEAR(ticks, 600, 1) << rate << " frames a second";
    EXPECT_EQ(timestep.dropped(), 0u);
  }
}

TEST(FixedTimestepTest, TheFirstFrameOnlySetsTheClock) {
  FixedTimestep timestep;
  EXPECT_EQ(ticksOf(timestep, 123456.0), 0u);
}

TEST(FixedTimestepTest, AlphaRunsFromTickToTick) {
  FixedTimestep timestep;
  ticksOf(timestep, 0);
  EXPECT_EQ(ticksOf(timestep, kTick * 1.25), 1u);
  EXPECT_NEAR(timestep.alpha(), 0.25, 1e-5);
  EXPECT_EQ(ticksOf(timestep, kTick * 1.75), 0u);
  EXPECT_NEAR(timestep.alpha(), 0.75, 1e-5);
}

TEST(FixedTimestepTest, CatchesUpAtMostFiveTicksAndCountsTheRest) {
  FixedTimestep timestep;
  ticksOf(timestep, 0);
  EXPECT_EQ(ticksOf(timestep, kTick * 5.5), 5u);
  EXPECT_EQ(timestep.dropped(), 0u);
  EXPECT_EQ(ticksOf(timestep, kTick * (5.5 + 20)), 5u);
  EXPECT_EQ(timestep.dropped(), 15u);
  EXPECT_EQ(ticksOf(timestep, kTick * (5.5 + 21)), 1u) << "the surplus is gone, not postponed";
}

TEST(FixedTimestepTest, HitStopWithholdsTicksAndNeverCatchesUp) {
  FixedTimestep timestep;
  timestep.frame(0);
  timestep.frame(kTick);
  ASSERT_TRUE(timestep.due());
  timestep.withhold(0.066);  // four ticks, less a bit
  EXPECT_TRUE(timestep.holding());
  uint32_t ticks = 0;
  double now = kTick;
  for (int frame = 0; frame < 60; ++frame) ticks += ticksOf(timestep, now += 1.0 / 120);
  EXPECT_EQ(ticks, 26u) << "30 ticks in half a second, less 66 ms of them";
  EXPECT_FALSE(timestep.holding());
  EXPECT_EQ(timestep.dropped(), 0u);
}

TEST(FixedTimestepTest, TicksStillDueInTheFrameArePartOfTheHitStop) {
  FixedTimestep timestep;
  timestep.frame(0);
  timestep.frame(kTick * 4);
  ASSERT_TRUE(timestep.due());
  timestep.withhold(kTick * 2);
  EXPECT_TRUE(timestep.due()) << "two of the three waiting ticks were swallowed";
  EXPECT_FALSE(timestep.due());
}

TEST(FixedTimestepTest, PausedTimeDoesNotPass) {
  FixedTimestep timestep;
  ticksOf(timestep, 0);
  timestep.pause();
  EXPECT_EQ(ticksOf(timestep, 100), 0u);
  timestep.resume();
  EXPECT_EQ(ticksOf(timestep, 100 + kTick), 1u);
  EXPECT_EQ(timestep.dropped(), 0u);
}

TEST(FixedTimestepTest, AClockThatJumpsBackIsHarmless) {
  FixedTimestep timestep;
  ticksOf(timestep, 10);
  EXPECT_EQ(ticksOf(timestep, 5), 0u);
  EXPECT_EQ(ticksOf(timestep, 5 + kTick), 1u);
}

TEST(FixedTimestepTest, FourTimesTheSpeedIsFourTimesTheTicks) {
  FixedTimestep timestep;
  timestep.setSpeed(4);
  uint32_t ticks = 0;
  for (int frame = 0; frame <= 30; ++frame) ticks += ticksOf(timestep, frame / 30.0);
  EXPECT_NEAR(ticks, 240, 1);
  EXPECT_EQ(timestep.dropped(), 0u);
}

}  // namespace
}  // namespace gw
