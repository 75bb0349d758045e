// Sticks in, records out: dead zones, discs and what no stick should report; which of several pads plays.
#include "game/input/gamepad.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace gw {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(StickTest, WithinTheDeadZoneItIsExactlyZero) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const float angle = float(degrees) * 0.0174533f;
    for (const float length : {0.0f, 0.01f, 0.1f, 0.199f}) {
      const Stick stick = shapeStick(length * std::cos(angle), length * std::sin(angle), 0.2f);
      EXPECT_EQ(stick.x, 0);
      EXPECT_EQ(stick.y, 0);
    }
  }
  EXPECT_EQ(shapeStick(0.2f, 0, 0.2f).x, 0) << "its edge belongs to it";
  EXPECT_EQ(shapeStick(0, 0, 0).x, 0) << "without one the centre is still the centre";
}

TEST(StickTest, FromTheDeadZoneTheLengthGrowsFromZeroToOne) {
  EXPECT_NEAR(shapeStick(0.201f, 0, 0.2f).x, 0.00125f, 1e-5f);
  EXPECT_NEAR(shapeStick(0.6f, 0, 0.2f).x, 0.5f, 1e-5f);
  EXPECT_EQ(shapeStick(1, 0, 0.2f).x, 1);
  EXPECT_EQ(shapeStick(0, -1, 0.2f).y, -1);
}

TEST(StickTest, TheCornersOfTheSquareLieOnTheDisc) {
  const Stick corner = shapeStick(1, -1, 0.2f);
  EXPECT_NEAR(std::hypot(corner.x, corner.y), 1, 1e-6f);
  EXPECT_NEAR(corner.x, -corner.y, 1e-6f);
}

TEST(StickTest, WhatIsNoNumberIsAStickNobodyTouches) {
  for (const float bad : {kNan, kInf, -kInf, -kNan}) {
    for (const auto& [x, y] : {std::pair{bad, 0.5f}, {0.5f, bad}, {bad, bad}}) {
      EXPECT_EQ(shapeStick(x, y, 0.2f).x, 0);
      EXPECT_EQ(shapeStick(x, y, 0.2f).y, 0);
    }
    EXPECT_EQ(quantiseStick(bad), 0);
  }
  EXPECT_EQ(shapeStick(1, 0, kNan).x, 0);
  EXPECT_EQ(shapeStick(1e30f, 0, 0.2f).x, 1);
}

TEST(StickTest, QuantisationIsSymmetricAndNeverReachesTheOddValue) {
  EXPECT_EQ(axisShare(-32768), -1);
  EXPECT_EQ(axisShare(-32767), -1);
  EXPECT_EQ(axisShare(32767), 1);
  EXPECT_EQ(axisShare(0), 0);
  EXPECT_EQ(quantiseStick(1), kStickFull);
  EXPECT_EQ(quantiseStick(-1), -kStickFull);
  EXPECT_EQ(quantiseStick(-7), -kStickFull);
  int16_t before = std::numeric_limits<int16_t>::min();
  for (int raw = -32767; raw <= 32767; ++raw) {
    const int16_t step = quantiseStick(axisShare(int16_t(raw)));
    ASSERT_EQ(step, raw) << "a stick without a dead zone comes through as it is";
    ASSERT_EQ(quantiseStick(axisShare(int16_t(-raw))), -step);
    ASSERT_GT(step, before);
    before = step;
  }
}

RC_GTEST_PROP(StickTest, AnyTwoAxesGiveARecordThatTheGameTakes, (int16_t rawX, int16_t rawY)) {
  const float deadZone = float(*rc::gen::inRange(0, 91)) / 100;
  const Stick stick = shapeStick(axisShare(rawX), axisShare(rawY), deadZone);
  const double x = quantiseStick(stick.x), y = quantiseStick(stick.y);
  RC_ASSERT(std::abs(x) <= kStickFull && std::abs(y) <= kStickFull);
  RC_ASSERT(std::hypot(x, y) <= kStickFull + 1.0);
  // The direction is the stick's own.
  RC_ASSERT(std::abs(double(stick.x) * axisShare(rawY) - double(stick.y) * axisShare(rawX)) < 1e-5);
  RC_ASSERT(double(stick.x) * axisShare(rawX) >= 0 && double(stick.y) * axisShare(rawY) >= 0);
  // Mirrored input, mirrored output; farther out is never shorter.
  const Stick mirrored = shapeStick(-axisShare(rawX), -axisShare(rawY), deadZone);
  RC_ASSERT(mirrored.x == -stick.x && mirrored.y == -stick.y);
  const Stick nearer = shapeStick(axisShare(rawX) / 2, axisShare(rawY) / 2, deadZone);
  RC_ASSERT(std::hypot(nearer.x, nearer.y) <= std::hypot(stick.x, stick.y) + 1e-6);
}

class GamepadTest : public ::testing::Test {
 protected:
  void axis(SDL_GameControllerAxis which, int16_t value, SDL_JoystickID id = 3) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.which = id;
    event.caxis.axis = uint8_t(which);
    event.caxis.value = value;
    event.caxis.timestamp = now_ms;
    pad.handle(event, turns);
  }
  void button(uint8_t which, bool down, SDL_JoystickID id = 3) {
    SDL_Event event{};
    event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.which = id;
    event.cbutton.button = which;
    event.cbutton.timestamp = now_ms;
    pad.handle(event, turns);
  }
  void remove(SDL_JoystickID id = 3) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERDEVICEREMOVED;
    event.cdevice.which = id;
    pad.handle(event, turns);
  }

  Gamepad pad;
  PadArbiter turns;
  uint32_t now_ms = 0;
};

TEST_F(GamepadTest, SticksPointUpWhereTheyArePushedUp) {
  axis(SDL_CONTROLLER_AXIS_LEFTY, -32768);
  EXPECT_EQ(pad.move().y, 1);
  EXPECT_EQ(pad.move().x, 0);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  EXPECT_EQ(pad.aim().x, 1);
  EXPECT_EQ(pad.aim().y, 0);
}

TEST_F(GamepadTest, EachStickHasItsOwnDeadZone) {
  pad.setDeadZones(0.1f, 0.6f);
  button(SDL_CONTROLLER_BUTTON_X, true);  // it plays
  axis(SDL_CONTROLLER_AXIS_LEFTX, 16384);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 16384);
  EXPECT_GT(pad.move().x, 0.4f);
  EXPECT_EQ(pad.aim().x, 0);
}

TEST_F(GamepadTest, DriftWithinTheDeadZoneIsNothingAtAll) {
  button(SDL_CONTROLLER_BUTTON_X, true);
  for (int16_t drift = -6500; drift <= 6500; drift = int16_t(drift + 130)) {
    axis(SDL_CONTROLLER_AXIS_LEFTX, drift);
    axis(SDL_CONTROLLER_AXIS_RIGHTY, drift);
    EXPECT_EQ(quantiseStick(pad.move().x), 0);
    EXPECT_EQ(quantiseStick(pad.aim().y), 0);
  }
}

TEST_F(GamepadTest, TriggersAreButtonsThatDoNotFlutter) {
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 10000);
  EXPECT_FALSE(pad.held(Action::flush));
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 17000);
  EXPECT_TRUE(pad.held(Action::flush));
  pad.recorded();
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 14000);
  EXPECT_TRUE(pad.held(Action::flush)) << "half way back it is still down";
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 17000);
  EXPECT_TRUE(pad.pressed(Action::flush));
  EXPECT_FALSE(pad.pressed(Action::flush)) << "and was not pressed twice";
  axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0);
  EXPECT_FALSE(pad.held(Action::flush));
}

TEST_F(GamepadTest, ButtonsArePressedOnceAndATapCountsForOneRecord) {
  button(SDL_CONTROLLER_BUTTON_START, true);
  button(SDL_CONTROLLER_BUTTON_START, true);
  button(SDL_CONTROLLER_BUTTON_START, false);
  EXPECT_TRUE(pad.pressed(Action::pause));
  EXPECT_FALSE(pad.pressed(Action::pause));
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, false);
  EXPECT_TRUE(pad.held(Action::flush));
  pad.recorded();
  EXPECT_FALSE(pad.held(Action::flush));
}

TEST_F(GamepadTest, ThePadUsedLastPlaysAndDriftDoesNotCountAsUse) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 12000, 1);
  EXPECT_FALSE(pad.plays()) << "a pad that lies on the table and drifts";
  EXPECT_EQ(pad.move().x, 0);
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767, 2);
  EXPECT_EQ(pad.move().x, 1);
  now_ms += 1000;
  axis(SDL_CONTROLLER_AXIS_LEFTX, -32767, 1);
  EXPECT_EQ(pad.move().x, -1);
  axis(SDL_CONTROLLER_AXIS_LEFTX, 12000, 2);
  EXPECT_EQ(pad.move().x, -1);
  now_ms += 1000;
  button(SDL_CONTROLLER_BUTTON_A, true, 2);
  EXPECT_GT(pad.move().x, 0);
}

TEST_F(GamepadTest, APadThatIsListedTwicePressesOnce) {
  for (now_ms = 0xffffff00; now_ms != 0x400; now_ms += 64) {  // across the end of the clock
    for (const uint8_t which : {SDL_CONTROLLER_BUTTON_START, SDL_CONTROLLER_BUTTON_LEFTSHOULDER}) {
      const SDL_JoystickID first = 1 + int(now_ms / 64 % 2), second = 3 - first;  // either may be the earlier
      for (const bool down : {true, false}) {
        button(which, down, first);
        now_ms += 8;
        button(which, down, second);
        now_ms += 56;
      }
    }
    EXPECT_TRUE(pad.pressed(Action::pause) && pad.pressed(Action::flush));
    EXPECT_FALSE(pad.pressed(Action::pause) || pad.pressed(Action::flush)) << now_ms;
  }
}

TEST_F(GamepadTest, AStickOfAPadListedTwiceTakesOverOnce) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 20000, 1);
  now_ms += 8;
  axis(SDL_CONTROLLER_AXIS_LEFTX, 30000, 1);
  axis(SDL_CONTROLLER_AXIS_LEFTX, 20000, 2);
  EXPECT_GT(pad.move().x, 0.85f) << "the later copy does not pull it back";
  remove(2);
  EXPECT_FALSE(pad.lost());
}

TEST_F(GamepadTest, AStickThatIsHeldOutKeepsNoOtherPadFromPressing) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767, 1);
  for (int i = 0; i < 20; ++i) {
    now_ms += 8;
    axis(SDL_CONTROLLER_AXIS_LEFTX, int16_t(32000 + i), 1);
  }
  button(SDL_CONTROLLER_BUTTON_START, true, 2);
  EXPECT_TRUE(pad.pressed(Action::pause));
}

TEST_F(GamepadTest, WhenThePadThatPlaysGoesEverythingIsNeutral) {
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  remove(9);
  EXPECT_FALSE(pad.lost()) << "another one went";
  EXPECT_EQ(pad.move().x, 1);
  remove();
  EXPECT_TRUE(pad.lost());
  EXPECT_FALSE(pad.lost());
  EXPECT_EQ(pad.move().x, 0);
  EXPECT_EQ(pad.aim().x, 0);
  EXPECT_FALSE(pad.held(Action::flush));
  axis(SDL_CONTROLLER_AXIS_LEFTX, 32767, 4);  // connected again it has another number
  EXPECT_EQ(pad.move().x, 1);
}

TEST_F(GamepadTest, AButtonThatStartsARunDoesNotFlushInIt) {
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  pad.beginPlay();
  EXPECT_FALSE(pad.held(Action::flush));
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, false);
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  EXPECT_TRUE(pad.held(Action::flush));
}

TEST_F(GamepadTest, OddEventsAreSurvived) {
  axis(SDL_GameControllerAxis(200), 32767);
  button(255, true);
  button(kPadLeftTrigger, true);  // no pad sends a trigger as a button
  EXPECT_FALSE(pad.held(Action::flush));
  remove(-1);
  EXPECT_FALSE(pad.lost());
}

}  // namespace
}  // namespace gw
