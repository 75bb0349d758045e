// Keyboard, mouse and pad together; menus; listening for a new key.
#include "game/input/player_input.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw {
namespace {

class PlayerInputTest : public ::testing::Test {
 protected:
  void key(SDL_Scancode code, bool down, bool repeat = false) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.scancode = code;
    event.key.repeat = repeat;
    input.handle(event);
  }
  void mouse(int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = x;
    event.motion.y = y;
    input.handle(event);
  }
  void axis(SDL_GameControllerAxis which, int16_t value, SDL_JoystickID id = 0) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.which = id;
    event.caxis.axis = uint8_t(which);
    event.caxis.value = value;
    event.caxis.timestamp = now_ms;
    input.handle(event);
  }
  void button(uint8_t which, bool down, SDL_JoystickID id = 0) {
    SDL_Event event{};
    event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.which = id;
    event.cbutton.button = which;
    event.cbutton.timestamp = now_ms;
    input.handle(event);
  }
  // By a pad that is listed twice, its events 8 ms apart.
  void tapTwin(uint8_t which) {
    for (const bool down : {true, false}) {
      button(which, down, 1);
      now_ms += 8;
      button(which, down, 2);
      now_ms += 100;
    }
  }
  void removePad() {
    SDL_Event event{};
    event.type = SDL_CONTROLLERDEVICEREMOVED;
    input.handle(event);
  }
  InputRecord record(WorldPoint pointer = {}) { return input.record({0, 0}, pointer); }

  PlayerInput input;
  uint32_t now_ms = 0;
};

TEST_F(PlayerInputTest, ThePadMovesAimsAndFires) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, -32768);
  axis(SDL_CONTROLLER_AXIS_RIGHTY, -32768);
  EXPECT_EQ(record(), (InputRecord{-kStickFull, 0, 16384, kButtonFire}));
  axis(SDL_CONTROLLER_AXIS_LEFTX, 0);
  axis(SDL_CONTROLLER_AXIS_RIGHTY, 0);
  EXPECT_EQ(record(), (InputRecord{0, 0, 16384, 0})) << "at rest nothing moves, and the aim stays";
  button(SDL_CONTROLLER_BUTTON_DPAD_UP, true);
  EXPECT_EQ(record().move_y, kStickFull);
}

TEST_F(PlayerInputTest, MovesAddUpWithinTheDisc) {
  key(SDL_SCANCODE_D, true);
  EXPECT_EQ(record().move_x, kStickFull);
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  EXPECT_EQ(record().move_x, kStickFull) << "twice the same is no faster";
  axis(SDL_CONTROLLER_AXIS_LEFTX, 0);
  axis(SDL_CONTROLLER_AXIS_LEFTY, -32767);
  const InputRecord both = record();
  EXPECT_NEAR(std::hypot(both.move_x, both.move_y), kStickFull, 1);
  EXPECT_NEAR(both.move_x, both.move_y, 1);
  axis(SDL_CONTROLLER_AXIS_LEFTY, 0);
  axis(SDL_CONTROLLER_AXIS_LEFTX, -32767);
  EXPECT_EQ(record().move_x, 0) << "against each other they stand still";
}

TEST_F(PlayerInputTest, TheAimBelongsToWhoAimedLast) {
  mouse(5, 5);
  EXPECT_EQ(record({-5, 0}).aim, 32768);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  EXPECT_EQ(record({-5, 0}).aim, 0);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 0);
  EXPECT_EQ(record({-5, 0}).aim, 0) << "a mouse that only lies there does not take the aim back";
  EXPECT_FALSE(input.aimsByMouse());
  mouse(6, 5);
  EXPECT_EQ(record({-5, 0}).aim, 32768);
  key(SDL_SCANCODE_UP, true);
  EXPECT_EQ(record({-5, 0}).aim, 16384);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  EXPECT_EQ(record({-5, 0}).aim, 0) << "a deflected stick overrules the arrows";
}

TEST_F(PlayerInputTest, PadButtonsMayAimAndFireToo) {
  Bindings bindings;
  bindings.codes(InputDevice::pad, Action::aimLeft) = {kPadX};
  bindings.codes(InputDevice::pad, Action::fire) = {kPadA};
  input.setBindings(bindings);
  button(kPadX, true);
  EXPECT_EQ(record(), (InputRecord{0, 0, 32768, kButtonFire}));
  button(kPadX, false);
  button(kPadA, true);
  EXPECT_EQ(record(), (InputRecord{0, 0, 32768, kButtonFire}));
}

TEST_F(PlayerInputTest, LosingThePadInUseIsToldAndNeutral) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  ASSERT_TRUE(input.padInUse());
  removePad();
  EXPECT_EQ(record(), (InputRecord{0, 0, 16384, 0})) << "nothing moves, nothing fires";
  EXPECT_TRUE(input.lostPad());
  EXPECT_FALSE(input.lostPad());
  EXPECT_FALSE(input.padInUse());
}

TEST_F(PlayerInputTest, NobodyMissesAPadThatHeLaidAside) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  axis(SDL_CONTROLLER_AXIS_LEFTX, 0);
  key(SDL_SCANCODE_W, true);
  removePad();
  EXPECT_FALSE(input.lostPad());
  EXPECT_EQ(record().move_y, kStickFull) << "the keyboard goes on";
}

TEST_F(PlayerInputTest, LosingTheFocusReleasesThePadToo) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  input.handle(event);
  EXPECT_EQ(record().move_x, 0);
  EXPECT_TRUE(input.lostFocus());
}

TEST_F(PlayerInputTest, TheSpaceThatStartsARunDoesNotFlushInIt) {
  key(SDL_SCANCODE_SPACE, true);
  key(SDL_SCANCODE_W, true);
  input.beginPlay();
  EXPECT_EQ(record(), (InputRecord{0, kStickFull, 16384, 0})) << "but a held move goes on";
  key(SDL_SCANCODE_SPACE, false);
  key(SDL_SCANCODE_SPACE, true);
  EXPECT_EQ(record().buttons, kButtonFlush);
}

TEST_F(PlayerInputTest, OtherKeysMayDoEverything) {
  Bindings bindings;
  bindings.codes(InputDevice::keyboard, Action::moveUp) = {SDL_SCANCODE_I, SDL_SCANCODE_KP_8};
  bindings.codes(InputDevice::keyboard, Action::fire) = {SDL_SCANCODE_J};
  bindings.codes(InputDevice::mouse, Action::fire) = {};
  key(SDL_SCANCODE_W, true);
  input.setBindings(bindings);
  EXPECT_EQ(record().move_y, 0) << "what was held is released";
  key(SDL_SCANCODE_W, true, true);
  EXPECT_EQ(record().move_y, 0) << "a repeat is no press";
  key(SDL_SCANCODE_KP_8, true);
  key(SDL_SCANCODE_J, true);
  EXPECT_EQ(record(), (InputRecord{0, kStickFull, 16384, kButtonFire}));
}

TEST_F(PlayerInputTest, ListeningKeepsTheNextPressFromActing) {
  input.listen();
  key(SDL_SCANCODE_F, true);
  EXPECT_FALSE(input.pressed(Action::fullscreen));
  EXPECT_EQ(input.heard(), (Control{InputDevice::keyboard, SDL_SCANCODE_F}));
  EXPECT_EQ(input.heard(), std::nullopt);
  EXPECT_FALSE(input.listening());
  key(SDL_SCANCODE_F, false);
  key(SDL_SCANCODE_F, true);
  EXPECT_TRUE(input.pressed(Action::fullscreen)) << "the next one acts again";
}

TEST_F(PlayerInputTest, ListeningHearsPadsAndMiceButNotEscape) {
  input.listen();
  key(SDL_SCANCODE_ESCAPE, true);
  EXPECT_EQ(input.heard(), std::nullopt);
  EXPECT_TRUE(input.menu(0).escape);
  ASSERT_TRUE(input.listening());
  axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 3000);
  EXPECT_TRUE(input.listening());
  axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
  EXPECT_EQ(input.heard(), (Control{InputDevice::pad, kPadRightTrigger}));
  input.listen();
  button(kPadB, true);
  EXPECT_EQ(input.heard(), (Control{InputDevice::pad, kPadB}));
  EXPECT_FALSE(input.menu(0).back);
  input.listen();
  SDL_Event click{};
  click.type = SDL_MOUSEBUTTONDOWN;
  click.button.button = 5;
  input.handle(click);
  EXPECT_EQ(input.heard(), (Control{InputDevice::mouse, 5}));
}

TEST_F(PlayerInputTest, MenusTakeArrowsAndPadsWhateverIsBound) {
  Bindings nothing;
  for (auto& device : nothing.of) {
    for (auto& codes : device) codes.clear();
  }
  input.setBindings(nothing);
  key(SDL_SCANCODE_DOWN, true);
  key(SDL_SCANCODE_DOWN, true, true);
  key(SDL_SCANCODE_RETURN, true);
  key(SDL_SCANCODE_RETURN, true, true);
  MenuPresses presses = input.menu(0);
  EXPECT_EQ(presses.down, 2) << "the keyboard's repeats count";
  EXPECT_TRUE(presses.confirm);
  EXPECT_FALSE(presses.back);
  button(kPadLeft, true);
  button(kPadB, true);
  presses = input.menu(0);
  EXPECT_EQ(presses.left, 1);
  EXPECT_TRUE(presses.back);
  EXPECT_FALSE(presses.escape);
  EXPECT_EQ(input.menu(0).left, 0);
}

TEST_F(PlayerInputTest, AHeldCrossOrStickRepeats) {
  button(kPadDown, true);
  EXPECT_EQ(input.menu(10).down, 1);
  EXPECT_EQ(input.menu(10.39).down, 0);
  EXPECT_EQ(input.menu(10.41).down, 1);
  EXPECT_EQ(input.menu(10.45).down, 0);
  EXPECT_EQ(input.menu(10.5).down, 1);
  button(kPadDown, false);
  EXPECT_EQ(input.menu(20).down, 0);
  axis(SDL_CONTROLLER_AXIS_LEFTY, -25000);
  axis(SDL_CONTROLLER_AXIS_LEFTY, -18000);
  axis(SDL_CONTROLLER_AXIS_LEFTY, -25000);
  EXPECT_EQ(input.menu(30).up, 1) << "a stick that trembles is pushed once";
  EXPECT_EQ(input.menu(30.5).up, 1);
  removePad();
  EXPECT_EQ(input.menu(40).up, 0);
}

TEST_F(PlayerInputTest, NumberKeysWheelAndClicksAreToldOnce) {
  key(SDL_SCANCODE_1, true);
  key(SDL_SCANCODE_7, true);
  EXPECT_EQ(input.number(), 7u) << "the last one";
  EXPECT_EQ(input.number(), 0u);
  key(SDL_SCANCODE_7, false);
  EXPECT_EQ(input.number(), 0u) << "letting go is no press";
  key(SDL_SCANCODE_0, true);
  EXPECT_EQ(input.number(), 0u);

  SDL_Event wheel{};
  wheel.type = SDL_MOUSEWHEEL;
  for (const int y : {3, -1}) {
    wheel.wheel.y = y;
    input.handle(wheel);
  }
  EXPECT_EQ(input.wheel(), 2);
  EXPECT_EQ(input.wheel(), 0);
  wheel.wheel.direction = SDL_MOUSEWHEEL_FLIPPED;
  wheel.wheel.y = 1;
  input.handle(wheel);
  EXPECT_EQ(input.wheel(), -1);

  SDL_Event click{};
  click.type = SDL_MOUSEBUTTONDOWN;
  click.button.button = SDL_BUTTON_RIGHT;
  input.handle(click);
  EXPECT_FALSE(input.clicked());
  click.button.button = SDL_BUTTON_LEFT;
  input.handle(click);
  EXPECT_TRUE(input.clicked());
  EXPECT_FALSE(input.clicked());

  key(SDL_SCANCODE_2, true);
  input.handle(wheel);
  input.forgetPresses();
  EXPECT_EQ(input.number(), 0u);
  EXPECT_EQ(input.wheel(), 0);
}

TEST_F(PlayerInputTest, AMenuTakesOneStepForAPadThatIsListedTwice) {
  tapTwin(kPadDown);
  tapTwin(kPadDown);
  EXPECT_EQ(input.menu(0).down, 2);
  // A stick on its way passes the limit in both copies, and the later one is still below it.
  for (const int16_t value : {12000, 18000, 21000, 25000, 32000}) {
    axis(SDL_CONTROLLER_AXIS_LEFTY, value, 1);
    now_ms += 4;
    axis(SDL_CONTROLLER_AXIS_LEFTY, int16_t(value - 9000), 2);
    now_ms += 4;
  }
  EXPECT_EQ(input.menu(1).down, 1);
  EXPECT_EQ(input.menu(1.5).down, 1) << "what is held repeats, once";
  EXPECT_EQ(input.menu(1.6).down, 1);
  tapTwin(kPadB);
  EXPECT_TRUE(input.menu(2).back);
}

TEST_F(PlayerInputTest, AnotherPadMayPressOnceTheFirstIsQuiet) {
  button(kPadDown, true, 1);
  now_ms += PadArbiter::kQuiet_ms - 1;
  button(kPadDown, true, 2);
  EXPECT_EQ(input.menu(0).down, 1);
  button(kPadDown, false, 2);
  now_ms += 1;
  button(kPadDown, true, 2);
  EXPECT_EQ(input.menu(0).down, 1);
  button(kPadDown, false, 2);
  EXPECT_EQ(input.menu(1).down, 0) << "the first one's hold does not repeat any more";
}

// At ten frames a second both presses of a twin come with frames that lie 100 ms apart.
TEST_F(PlayerInputTest, ASlowFrameBetweenTheTwoPressesOfATwinIsNoQuiet) {
  now_ms = 1000;
  button(kPadDown, true, 1);
  input.endFrame(now_ms);
  now_ms += 100;
  button(kPadDown, true, 2);
  input.endFrame(now_ms);
  EXPECT_EQ(input.menu(0).down, 1);
  button(kPadDown, false, 1);
  button(kPadDown, false, 2);
  input.endFrame(now_ms += 100);
  now_ms += 100;
  button(kPadDown, true, 2);
  EXPECT_EQ(input.menu(0).down, 1) << "a whole frame without a press is";
}

TEST_F(PlayerInputTest, APadThatIsPluggedInAnewNeedNotWait) {
  button(kPadDown, true, 1);
  SDL_Event gone{};
  gone.type = SDL_CONTROLLERDEVICEREMOVED;
  gone.cdevice.which = 1;
  input.handle(gone);
  button(kPadDown, true, 2);
  EXPECT_EQ(input.menu(0).down, 2);
}

// In practice one button brings enemies and the next one fewer; out of it they open the settings and lead back.
TEST_F(PlayerInputTest, PracticeAsksOnceForAPadThatIsListedTwice) {
  tapTwin(kPadY);
  EXPECT_TRUE(input.pressed(Action::spawn) && input.pressed(Action::settings));
  EXPECT_FALSE(input.pressed(Action::spawn) || input.pressed(Action::settings));
  tapTwin(kPadB);
  EXPECT_TRUE(input.pressed(Action::fewer) && input.pressed(Action::quit));
  EXPECT_FALSE(input.pressed(Action::fewer) || input.pressed(Action::quit));
}

TEST_F(PlayerInputTest, BindingHearsAPadThatIsListedTwiceOnce) {
  input.listen();
  button(kPadB, true, 1);
  EXPECT_EQ(input.heard(), (Control{InputDevice::pad, kPadB}));
  now_ms += 8;
  button(kPadB, true, 2);
  EXPECT_FALSE(input.pressed(Action::quit)) << "the second copy acts on nothing";
  EXPECT_FALSE(input.menu(0).back);
  input.listen();
  button(kPadX, true, 2);
  EXPECT_EQ(input.heard(), std::nullopt) << "nor is it heard";
  now_ms += 100;
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 32767, 2);
  EXPECT_EQ(input.heard(), (Control{InputDevice::pad, kPadLeftTrigger}));
}

}  // namespace
}  // namespace gw
