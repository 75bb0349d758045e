// How fast frames come, by a clock that is only counted; and full screen that takes its time.
#include "game/session/frame_limiter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "game/app/fullscreen_switch.h"
#include "game/session/fixed_timestep.h"

namespace gw {
namespace {

// A screen and a driver: how long a frame is made, and how long showing it waits.
struct Machine {
  FrameLimiter limiter;
  double now_s = 1000;

  // Frames in so many seconds. `swap`: when the swap ends that begins at a time.
  template <class Swap>
  int frames(double seconds, double work_s, bool waits, bool hidden, Swap swap) {
    int count = 0;
    for (const double end_s = now_s + seconds; now_s < end_s; ++count) {
      now_s = swap(now_s + work_s);
      now_s += limiter.wait_s(now_s, waits, hidden);
    }
    return count;
  }
};

double atOnce(double now_s) {
  return now_s;
}

double nextOf(double now_s, double rate) {
  return (std::floor(now_s * rate + 1e-6) + 1) / rate;
}

TEST(FrameLimiter, LeavesAScreenThatWaitsAlone) {
  for (const double rate : {30.0, 60.0, 144.0, 240.0}) {
    Machine machine;
    machine.limiter.setScreenRate(rate);
    const auto waited = [&](double now_s) { return nextOf(now_s, rate); };
    for (int frame = 0; frame < 300; ++frame) {
      machine.now_s = waited(machine.now_s + 0.001);
      ASSERT_EQ(machine.limiter.wait_s(machine.now_s, true, false), 0) << rate;
    }
  }
}

TEST(FrameLimiter, KnowsNoBetterThanAFastScreenOfUnknownRate) {
  Machine machine;
  EXPECT_NEAR(machine.frames(10, 0.001, true, false, [](double now_s) { return nextOf(now_s, 240); }), 2400, 10);
}

TEST(FrameLimiter, LateFramesAreNoReasonToDoubtTheScreen) {
  Machine machine;
  machine.limiter.setScreenRate(60);
  for (int frame = 0; frame < 300; ++frame) {  // a late one, shown at once, then one in time
    machine.now_s = frame % 2 == 0 ? machine.now_s + 1.9 / 60 : nextOf(machine.now_s, 60);
    ASSERT_EQ(machine.limiter.wait_s(machine.now_s, true, false), 0);
  }
}

TEST(FrameLimiter, ADriverThatSaysItWaitsAndDoesNotIsHeldToTheScreensRate) {
  for (const double rate : {60.0, 144.0}) {
    Machine machine;
    machine.limiter.setScreenRate(rate);
    EXPECT_NEAR(machine.frames(20, 0.0005, true, false, atOnce), 20 * rate, 20 * rate * 0.03) << rate;
  }
}

TEST(FrameLimiter, ADriverThatWaitsAgainIsTrustedAgain) {
  Machine machine;
  machine.limiter.setScreenRate(60);
  machine.frames(5, 0.001, true, false, atOnce);
  machine.frames(7, 0.001, true, false, [](double now_s) { return nextOf(now_s, 60); });
  for (int frame = 0; frame < 60; ++frame) {
    machine.now_s = nextOf(machine.now_s + 0.001, 60);
    ASSERT_EQ(machine.limiter.wait_s(machine.now_s, true, false), 0);
  }
}

TEST(FrameLimiter, WithoutVerticalSyncTheScreensRateOrSixty) {
  Machine known, unknown;
  known.limiter.setScreenRate(75);
  EXPECT_NEAR(known.frames(10, 0.001, false, false, atOnce), 750, 2);
  EXPECT_NEAR(unknown.frames(10, 0.001, false, false, atOnce), 600, 2);
  Machine slow;
  EXPECT_NEAR(slow.frames(10, 0.05, false, false, atOnce), 200, 2) << "what is late is not made up for";
}

TEST(FrameLimiter, AHiddenWindowIsSlowAndLosesNoTick) {
  for (const bool waits : {false, true}) {
    Machine machine;
    FixedTimestep timestep;
    uint32_t ticks = 0;
    timestep.frame(machine.now_s);
    const int frames = machine.frames(10, 0.001, waits, true, [&](double now_s) {
      timestep.frame(now_s);
      while (timestep.due()) ++ticks;
      return now_s;
    });
    EXPECT_NEAR(frames, 200, 2);
    EXPECT_NEAR(ticks, 600, 4);
    EXPECT_EQ(timestep.dropped(), 0u);
  }
}

TEST(FullscreenSwitch, IsWhatWasAskedForWhileThatMayStillHappen) {
  FullscreenSwitch screen;
  EXPECT_FALSE(screen.on());
  screen.ask(true, 10);
  EXPECT_FALSE(screen.look(false, 10.5));
  EXPECT_TRUE(screen.on()) << "a window manager takes its time";
  EXPECT_FALSE(screen.look(true, 10.6));
  EXPECT_TRUE(screen.on());
  EXPECT_FALSE(screen.look(false, 99)) << "it was left by other means";
  EXPECT_FALSE(screen.on());
}

TEST(FullscreenSwitch, SaysOnceThatItDidNotHappen) {
  FullscreenSwitch screen;
  screen.ask(true, 10);
  EXPECT_FALSE(screen.look(false, 10.9));
  EXPECT_TRUE(screen.look(false, 11.1));
  EXPECT_FALSE(screen.on());
  EXPECT_FALSE(screen.look(false, 12));
}

}  // namespace
}  // namespace gw
