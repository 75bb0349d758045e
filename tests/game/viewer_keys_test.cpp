// The viewer's keys and mouse, from the events that a window sends.
#include "game/viewer/viewer_keys.h"

#include <gtest/gtest.h>

namespace gw::test {
namespace {

SDL_Event key(SDL_Keycode sym, bool down = true, uint16_t mod = 0, bool repeat = false) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.sym = sym;
  // SDL knows no keyboard before it has a window.
  if (sym == SDLK_w) event.key.keysym.scancode = SDL_SCANCODE_W;
  if (sym == SDLK_a) event.key.keysym.scancode = SDL_SCANCODE_A;
  event.key.keysym.mod = mod;
  event.key.repeat = repeat;
  return event;
}

SDL_Event button(bool down, int x, int y) {
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = x;
  event.button.y = y;
  return event;
}

SDL_Event motion(int x, int y) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = x;
  event.motion.y = y;
  return event;
}

TEST(ViewerKeys, SayWhatWasPressedOnce) {
  ViewerKeys keys;
  for (const SDL_Keycode sym : {SDLK_SPACE, SDLK_PERIOD, SDLK_PERIOD, SDLK_COMMA, SDLK_EQUALS, SDLK_HOME, SDLK_c}) {
    EXPECT_TRUE(keys.handle(key(sym)));
  }
  EXPECT_TRUE(keys.handle(key(SDLK_RIGHT)));
  EXPECT_TRUE(keys.handle(key(SDLK_LEFT, true, KMOD_LSHIFT)));
  EXPECT_TRUE(keys.handle(key(SDLK_PAGEDOWN)));
  const ViewerPresses presses = keys.take();
  EXPECT_EQ(presses.pauses, 1);
  EXPECT_EQ(presses.ticks, 1);
  EXPECT_EQ(presses.speeds, 1);
  EXPECT_EQ(presses.seconds, 5 - 60 + 60);
  EXPECT_TRUE(presses.home && presses.freeCamera);
  EXPECT_FALSE(presses.end || presses.followShip);
  EXPECT_EQ(keys.take().pauses, 0);
}

TEST(ViewerKeys, RepeatStepsButNoSwitches) {
  ViewerKeys keys;
  keys.handle(key(SDLK_SPACE));
  EXPECT_TRUE(keys.handle(key(SDLK_SPACE, true, 0, true))) << "taken, and nothing done";
  keys.handle(key(SDLK_PERIOD));
  keys.handle(key(SDLK_PERIOD, true, 0, true));
  const ViewerPresses presses = keys.take();
  EXPECT_EQ(presses.pauses, 1);
  EXPECT_EQ(presses.ticks, 2);
}

TEST(ViewerKeys, LeaveTheGamesOwnKeysAlone) {
  ViewerKeys keys;
  for (const SDL_Keycode sym : {SDLK_ESCAPE, SDLK_p, SDLK_q, SDLK_f, SDLK_m, SDLK_RETURN}) {
    EXPECT_FALSE(keys.handle(key(sym)));
  }
}

TEST(ViewerKeys, HoldThePanUntilReleasedOrTheWindowLosesTheFocus) {
  ViewerKeys keys;
  keys.handle(key(SDLK_w));
  keys.handle(key(SDLK_a));
  EXPECT_EQ(keys.pan_x(), -1);
  EXPECT_EQ(keys.pan_y(), 1);
  keys.handle(key(SDLK_a, false));
  EXPECT_EQ(keys.pan_x(), 0);
  SDL_Event lost{};
  lost.type = SDL_WINDOWEVENT;
  lost.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  EXPECT_FALSE(keys.handle(lost));
  EXPECT_EQ(keys.pan_y(), 0);
}

TEST(ViewerKeys, DragOnlyWithTheButtonHeld) {
  ViewerKeys keys;
  EXPECT_FALSE(keys.pointerSeen());
  keys.handle(motion(100, 100));
  EXPECT_EQ(keys.take().drag_x, 0);
  keys.handle(button(true, 110, 100));
  keys.handle(motion(130, 90));
  const ViewerPresses presses = keys.take();
  EXPECT_TRUE(presses.clicked);
  EXPECT_EQ(presses.click_x, 110) << "where it went down, not where it is now";
  EXPECT_EQ(presses.drag_x, 20);
  EXPECT_EQ(presses.drag_y, -10);
  EXPECT_TRUE(keys.buttonHeld());
  keys.handle(button(false, 130, 90));
  keys.handle(motion(200, 90));
  EXPECT_EQ(keys.take().drag_x, 0);
  EXPECT_EQ(keys.pointer_x_px(), 200);
}

}  // namespace
}  // namespace gw::test
