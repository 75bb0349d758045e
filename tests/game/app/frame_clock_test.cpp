// Times of frames, and their rate as the screen shows it.
#include "game/app/frame_clock.h"

#include <gtest/gtest.h>

namespace gw::test {
namespace {

TEST(FrameClock, TheFirstFrameHasTakenNoTime) {
  FrameClock clock;
  clock.begin(100);
  EXPECT_EQ(clock.frameTime_s(), 0);
  clock.begin(100.25);
  EXPECT_EQ(clock.previous_s(), 100);
  EXPECT_EQ(clock.frameTime_s(), 0.25);
}

TEST(FrameClock, CountsShownFramesOverHalfASecond) {
  FrameClock clock;
  for (int frame = 0; frame <= 200; ++frame) {
    clock.begin(100 + frame / 50.0);
    clock.count();
  }
  EXPECT_NEAR(clock.perSecond(), 50, 0.5);
}

TEST(FrameClock, KnowsNoRateAfterAStall) {
  FrameClock clock;
  for (int frame = 0; frame <= 200; ++frame) {
    clock.begin(100 + frame / 50.0);
    clock.count();
  }
  clock.begin(120);
  clock.count();
  EXPECT_EQ(clock.perSecond(), 0);
}

}  // namespace
}  // namespace gw::test
