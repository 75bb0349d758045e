// The viewer's keys and mouse, from the events that a window sends.
#include "game/replay_viewer/viewer_keys.h"

#include <gtest/gtest.h>

namespace gw::test {
namespace {

// sym: what the layout has there, where that matters.
SDL_Event key(SDL_Scancode code, bool down = true, uint16_t mod = 0, bool repeat = false, SDL_Keycode sym = 0) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.scancode = code;
  event.key.keysym.sym = sym;
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
  for (const SDL_Scancode code : {SDL_SCANCODE_SPACE, SDL_SCANCODE_PERIOD, SDL_SCANCODE_PERIOD, SDL_SCANCODE_COMMA,
                                  SDL_SCANCODE_EQUALS, SDL_SCANCODE_HOME, SDL_SCANCODE_C}) {
    EXPECT_TRUE(keys.handle(key(code)));
  }
  EXPECT_TRUE(keys.handle(key(SDL_SCANCODE_RIGHT)));
  EXPECT_TRUE(keys.handle(key(SDL_SCANCODE_LEFT, true, KMOD_LSHIFT)));
  EXPECT_TRUE(keys.handle(key(SDL_SCANCODE_PAGEDOWN)));
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
  keys.handle(key(SDL_SCANCODE_SPACE));
  EXPECT_TRUE(keys.handle(key(SDL_SCANCODE_SPACE, true, 0, true))) << "taken, and nothing done";
  keys.handle(key(SDL_SCANCODE_PERIOD));
  keys.handle(key(SDL_SCANCODE_PERIOD, true, 0, true));
  const ViewerPresses presses = keys.take();
  EXPECT_EQ(presses.pauses, 1);
  EXPECT_EQ(presses.ticks, 2);
}

TEST(ViewerKeys, GoByPlaceOnEveryLayout) {
  ViewerKeys keys;
  // Russian and French: no key gives "." or "c" there, and the one below is the game's own mute.
  keys.handle(key(SDL_SCANCODE_PERIOD, true, 0, false, 0x44e));
  keys.handle(key(SDL_SCANCODE_PERIOD, true, 0, false, SDLK_COLON));
  keys.handle(key(SDL_SCANCODE_C, true, 0, false, 0x441));
  EXPECT_FALSE(keys.handle(key(SDL_SCANCODE_M, true, 0, false, SDLK_COMMA)));
  const ViewerPresses presses = keys.take();
  EXPECT_EQ(presses.ticks, 2);
  EXPECT_TRUE(presses.freeCamera);
}

TEST(ViewerKeys, TakePlusAndMinusWhereTheLayoutHasThem) {
  ViewerKeys keys;
  const auto steps = [&](SDL_Scancode code, SDL_Keycode sym) {
    EXPECT_TRUE(keys.handle(key(code, true, 0, false, sym)));
    return keys.take().speeds;
  };
  EXPECT_EQ(steps(SDL_SCANCODE_EQUALS, SDLK_EQUALS), 1);
  EXPECT_EQ(steps(SDL_SCANCODE_MINUS, SDLK_MINUS), -1);
  EXPECT_EQ(steps(SDL_SCANCODE_KP_PLUS, SDLK_KP_PLUS), 1);
  EXPECT_EQ(steps(SDL_SCANCODE_RIGHTBRACKET, SDLK_PLUS), 1) << "German";
  EXPECT_EQ(steps(SDL_SCANCODE_SLASH, SDLK_MINUS), -1) << "German";
  EXPECT_EQ(steps(SDL_SCANCODE_MINUS, SDLK_PLUS), 1) << "Swedish";
  EXPECT_EQ(steps(SDL_SCANCODE_MINUS, SDLK_RIGHTPAREN), -1) << "French";
}

TEST(ViewerKeys, LeaveTheGamesOwnKeysAlone) {
  ViewerKeys keys;
  for (const SDL_Scancode code :
       {SDL_SCANCODE_ESCAPE, SDL_SCANCODE_P, SDL_SCANCODE_Q, SDL_SCANCODE_F, SDL_SCANCODE_M, SDL_SCANCODE_RETURN}) {
    EXPECT_FALSE(keys.handle(key(code)));
  }
}

TEST(ViewerKeys, HoldThePanUntilReleasedOrTheWindowLosesTheFocus) {
  ViewerKeys keys;
  keys.handle(key(SDL_SCANCODE_W));
  keys.handle(key(SDL_SCANCODE_A));
  EXPECT_EQ(keys.pan_x(), -1);
  EXPECT_EQ(keys.pan_y(), 1);
  keys.handle(key(SDL_SCANCODE_A, false));
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
