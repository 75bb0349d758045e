#include <gtest/gtest.h>

#include "game/session/tick_pacer.h"

namespace gw {
namespace {

constexpr double kTick = 1.0 / 60;

uint32_t ticksOf(TickPacer& pacer, double now) {
  pacer.frame(now);
  uint32_t ticks = 0;
  while (pacer.due()) ++ticks;
  return ticks;
}

TEST(LoopPacerTest, SixtyTicksASecondAtEveryFrameRate) {
  for (const double rate : {24.0, 30.0, 59.94, 60.0, 75.0, 144.0, 240.0, 1000.0}) {
    TickPacer pacer;
    uint32_t ticks = 0;
    for (int frame = 0; frame <= int(10 * rate); ++frame) ticks += ticksOf(pacer, 5 + frame / rate);
    EXPECT_NEAR(ticks, 600, 1) << rate << " frames a second";
    EXPECT_EQ(pacer.dropped(), 0u);
  }
}

TEST(LoopPacerTest, TheFirstFrameOnlySetsTheClock) {
  TickPacer pacer;
  EXPECT_EQ(ticksOf(pacer, 123456.0), 0u);
}

TEST(LoopPacerTest, AlphaRunsFromTickToTick) {
  TickPacer pacer;
  ticksOf(pacer, 0);
  EXPECT_EQ(ticksOf(pacer, kTick * 1.25), 1u);
  EXPECT_NEAR(pacer.alpha(), 0.25, 1e-5);
  EXPECT_EQ(ticksOf(pacer, kTick * 1.75), 0u);
  EXPECT_NEAR(pacer.alpha(), 0.75, 1e-5);
}

TEST(LoopPacerTest, CatchesUpAtMostFiveTicksAndCountsTheRest) {
  TickPacer pacer;
  ticksOf(pacer, 0);
  EXPECT_EQ(ticksOf(pacer, kTick * 5.5), 5u);
  EXPECT_EQ(pacer.dropped(), 0u);
  EXPECT_EQ(ticksOf(pacer, kTick * (5.5 + 20)), 5u);
  EXPECT_EQ(pacer.dropped(), 15u);
  EXPECT_EQ(ticksOf(pacer, kTick * (5.5 + 21)), 1u) << "the surplus is gone, not postponed";
}

TEST(LoopPacerTest, HitStopWithholdsTicksAndNeverCatchesUp) {
  TickPacer pacer;
  pacer.frame(0);
  pacer.frame(kTick);
  ASSERT_TRUE(pacer.due());
  pacer.withhold(0.066);  // four ticks, less a bit
  EXPECT_TRUE(pacer.holding());
  uint32_t ticks = 0;
  double now = kTick;
  for (int frame = 0; frame < 60; ++frame) ticks += ticksOf(pacer, now += 1.0 / 120);
  EXPECT_EQ(ticks, 26u) << "30 ticks in half a second, less 66 ms of them";
  EXPECT_FALSE(pacer.holding());
  EXPECT_EQ(pacer.dropped(), 0u);
}

TEST(LoopPacerTest, TicksStillDueInTheFrameArePartOfTheHitStop) {
  TickPacer pacer;
  pacer.frame(0);
  pacer.frame(kTick * 4);
  ASSERT_TRUE(pacer.due());
  pacer.withhold(kTick * 2);
  EXPECT_TRUE(pacer.due()) << "two of the three waiting ticks were swallowed";
  EXPECT_FALSE(pacer.due());
}

TEST(LoopPacerTest, PausedTimeDoesNotPass) {
  TickPacer pacer;
  ticksOf(pacer, 0);
  pacer.pause();
  EXPECT_EQ(ticksOf(pacer, 100), 0u);
  pacer.resume();
  EXPECT_EQ(ticksOf(pacer, 100 + kTick), 1u);
  EXPECT_EQ(pacer.dropped(), 0u);
}

TEST(LoopPacerTest, AClockThatJumpsBackIsHarmless) {
  TickPacer pacer;
  ticksOf(pacer, 10);
  EXPECT_EQ(ticksOf(pacer, 5), 0u);
  EXPECT_EQ(ticksOf(pacer, 5 + kTick), 1u);
}

TEST(LoopPacerTest, FourTimesTheSpeedIsFourTimesTheTicks) {
  TickPacer pacer;
  pacer.setSpeed(4);
  uint32_t ticks = 0;
  for (int frame = 0; frame <= 30; ++frame) ticks += ticksOf(pacer, frame / 30.0);
  EXPECT_NEAR(ticks, 240, 1);
  EXPECT_EQ(pacer.dropped(), 0u);
}

}  // namespace
}  // namespace gw
