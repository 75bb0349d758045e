#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "game/input/keyboard_mouse.h"

namespace gw {
namespace {

class InputTest : public ::testing::Test {
 protected:
  void key(SDL_Scancode code, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.scancode = code;
    input.handle(event);
  }
  void button(uint8_t which, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
    event.button.button = which;
    input.handle(event);
  }
  void moveMouse(int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = x;
    event.motion.y = y;
    input.handle(event);
  }
  void loseFocus() {
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
    input.handle(event);
  }
  InputRecord record(WorldPoint pointer = {}) { return input.record({0, 0}, pointer); }

  KeyboardMouse input;
};

TEST_F(InputTest, NothingHeldIsARestingStick) {
  const InputRecord rest = record();
  EXPECT_EQ(rest.move_x, 0);
  EXPECT_EQ(rest.move_y, 0);
  EXPECT_EQ(rest.buttons, 0);
}

TEST_F(InputTest, WasdMovesAndDiagonalsAreNoFaster) {
  key(SDL_SCANCODE_W, true);
  EXPECT_EQ(record().move_y, kStickFull);
  key(SDL_SCANCODE_A, true);
  const InputRecord diagonal = record();
  EXPECT_LT(diagonal.move_x, 0);
  EXPECT_GT(diagonal.move_y, 0);
  EXPECT_NEAR(std::hypot(diagonal.move_x, diagonal.move_y), kStickFull, 1);
  key(SDL_SCANCODE_W, false);
  key(SDL_SCANCODE_A, false);
  EXPECT_EQ(record(), (InputRecord{0, 0, diagonal.aim, 0}));
}

TEST_F(InputTest, OfTwoOppositeKeysTheLaterWins) {
  key(SDL_SCANCODE_A, true);
  key(SDL_SCANCODE_D, true);
  EXPECT_EQ(record().move_x, kStickFull);
  key(SDL_SCANCODE_D, false);
  EXPECT_EQ(record().move_x, -kStickFull);
}

TEST_F(InputTest, ArrowsAimAndFireInEightDirections) {
  key(SDL_SCANCODE_RIGHT, true);
  EXPECT_EQ(record().aim, 0);
  EXPECT_EQ(record().buttons, kButtonFire);
  key(SDL_SCANCODE_UP, true);
  EXPECT_EQ(record().aim, 8192);
  key(SDL_SCANCODE_RIGHT, false);
  EXPECT_EQ(record().aim, 16384);
  key(SDL_SCANCODE_UP, false);
  key(SDL_SCANCODE_DOWN, true);
  EXPECT_EQ(record().aim, 49152);
  key(SDL_SCANCODE_DOWN, false);
  const InputRecord after = record();
  EXPECT_EQ(after.aim, 49152) << "the ship keeps looking where it last aimed";
  EXPECT_EQ(after.buttons, 0);
}

TEST_F(InputTest, TheMouseAimsFromTheShipAndTheLeftButtonFires) {
  moveMouse(400, 300);
  EXPECT_EQ(input.pointer_x_px(), 400);
  button(1, true);
  const InputRecord left = input.record({10, 10}, {0, 10});
  EXPECT_EQ(left.aim, 32768);
  EXPECT_EQ(left.buttons, kButtonFire);
  button(1, false);
  EXPECT_EQ(input.record({10, 10}, {10, 30}).buttons, 0);
  EXPECT_EQ(input.record({10, 10}, {10, 10}).aim, 16384) << "a pointer on the ship keeps the aim";
}

TEST_F(InputTest, ArrowsOverruleAStillMouse) {
  moveMouse(1, 1);
  EXPECT_EQ(record({-5, 0}).aim, 32768);
  key(SDL_SCANCODE_RIGHT, true);
  EXPECT_EQ(record({-5, 0}).aim, 0);
  key(SDL_SCANCODE_RIGHT, false);
  EXPECT_EQ(record({-5, 0}).aim, 0) << "a mouse that only lies there does not take the aim back";
  moveMouse(2, 1);
  EXPECT_EQ(record({-5, 0}).aim, 32768);
}

TEST_F(InputTest, SpaceAndTheRightButtonFlush) {
  key(SDL_SCANCODE_SPACE, true);
  EXPECT_EQ(record().buttons, kButtonFlush);
  key(SDL_SCANCODE_SPACE, false);
  EXPECT_EQ(record().buttons, 0);
  button(3, true);
  EXPECT_EQ(record().buttons, kButtonFlush);
}

TEST_F(InputTest, ATapBetweenTwoTicksCountsForOne) {
  key(SDL_SCANCODE_SPACE, true);
  key(SDL_SCANCODE_SPACE, false);
  EXPECT_EQ(record().buttons, kButtonFlush);
  EXPECT_EQ(record().buttons, 0);
}

TEST_F(InputTest, TwoKeysForOneActionAreReleasedOneByOne) {
  key(SDL_SCANCODE_SPACE, true);
  key(SDL_SCANCODE_LSHIFT, true);
  record();
  key(SDL_SCANCODE_SPACE, false);
  EXPECT_EQ(record().buttons, kButtonFlush);
  key(SDL_SCANCODE_LSHIFT, false);
  EXPECT_EQ(record().buttons, 0);
}

TEST_F(InputTest, LosingTheFocusReleasesEverything) {
  key(SDL_SCANCODE_W, true);
  button(1, true);
  loseFocus();
  const InputRecord rest = record();
  EXPECT_EQ(rest.move_y, 0);
  EXPECT_EQ(rest.buttons, 0);
  EXPECT_TRUE(input.lostFocus());
  EXPECT_FALSE(input.lostFocus());
  key(SDL_SCANCODE_W, false);  // the release of a key that counts as up already
  key(SDL_SCANCODE_W, true);
  EXPECT_EQ(record().move_y, kStickFull);
}

TEST_F(InputTest, PressesAreCountedOnceAndRepeatsNotAtAll) {
  key(SDL_SCANCODE_ESCAPE, true);
  key(SDL_SCANCODE_ESCAPE, true);  // the keyboard's repeat
  EXPECT_TRUE(input.pressed(Action::pause));
  EXPECT_FALSE(input.pressed(Action::pause));
  key(SDL_SCANCODE_RETURN, true);
  input.forgetPresses();
  EXPECT_FALSE(input.pressed(Action::confirm));
}

TEST_F(InputTest, AnglesAreQuantisedToTheNearestStepAndWrap) {
  constexpr float kTurn = float(2 * std::numbers::pi);
  EXPECT_EQ(quantiseAim(0.0f), 0);
  EXPECT_EQ(quantiseAim(kTurn / 4), 16384);
  EXPECT_EQ(quantiseAim(-kTurn / 4), 49152);
  EXPECT_EQ(quantiseAim(-kTurn / 1e7f), 0) << "just under a whole turn is the angle 0, not 65536";
  EXPECT_EQ(quantiseAim(std::nanf(""), 0.0f, 77), 77);
  for (int step = 0; step < 65536; step += 97) {
    EXPECT_EQ(quantiseAim(float(step) / 65536 * kTurn), step);
  }
}

}  // namespace
}  // namespace gw
