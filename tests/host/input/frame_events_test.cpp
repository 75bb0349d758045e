// The events of a frame: what a pad sends on its way out; and what SDL says of failures.
#include "host/input/frame_events.h"

#include <gtest/gtest.h>

#include "render/sdl_error.h"
#include "tests/replays/events.h"

namespace gw {
namespace {

TEST(FrameEvents, OfAPadThatGoesOnlyItsGoingIsLeft) {
  std::vector<SDL_Event> events = {padAxis(1, 0, 32767),  padAxis(2, 0, 32767), key(SDL_SCANCODE_A, true),
                                   padButton(1, 3, true), padGone(1),           padButton(2, 3, true)};
  dropLastEventsOfLeavingPads(events);
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].caxis.which, 2);
  EXPECT_EQ(events[1].type, uint32_t(SDL_KEYDOWN));
  EXPECT_EQ(events[2].type, uint32_t(SDL_CONTROLLERDEVICEREMOVED));
  EXPECT_EQ(events[3].cbutton.which, 2);
}

TEST(FrameEvents, StayAsTheyAreWhenNobodyGoes) {
  std::vector<SDL_Event> events = {padAxis(1, 0, 32767), padButton(1, 3, false), key(SDL_SCANCODE_A, true)};
  dropLastEventsOfLeavingPads(events);
  EXPECT_EQ(events.size(), 3u);
}

TEST(SdlReason, IsNothingWhereSdlSaysNothing) {
  SDL_ClearError();
  EXPECT_EQ(sdlReason(), "");
  SDL_SetError("no rumble");
  EXPECT_EQ(sdlReason(), " (no rumble)");
  SDL_ClearError();
}

}  // namespace
}  // namespace gw
