// The real path from SDL's joystick layer to the record, with a controller that SDL makes up: attached while the
// game runs, used, and pulled out.
#include <SDL.h>
#include <gtest/gtest.h>

#include "game/input/player_input.h"
#include "host/input/frame_events.h"
#include "host/input/pad_devices.h"

namespace gw {
namespace {

class VirtualPadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    // Whatever is really connected to this machine stays out of it.
    SDL_SetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES_EXCEPT, "0x0000/0x0001");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    pads = std::make_unique<PadDevices>();
    ASSERT_EQ(pads->problem(), "");
    pump();
  }
  void TearDown() override {
    while (!sticks.empty()) detach(sticks.back());
    pads.reset();
  }

  // What a frame does with the events.
  void pump() {
    const uint32_t looked_ms = SDL_GetTicks();
    takeEvents(events);
    for (const SDL_Event& event : events) {
      pads->handle(event);
      input.handle(event);
    }
    input.endFrame(looked_ms);
  }
  // Long enough for another pad to press.
  void rest() {
    SDL_Delay(PadArbiter::kQuiet_ms + 10);
    pump();
  }
  SDL_Joystick* attach() {
    const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                                 SDL_CONTROLLER_BUTTON_MAX, 0);
    EXPECT_GE(device, 0) << SDL_GetError();
    sticks.push_back(SDL_JoystickOpen(device));
    EXPECT_NE(sticks.back(), nullptr) << SDL_GetError();
    pump();
    return sticks.back();
  }
  void detach(SDL_Joystick* stick) {
    const SDL_JoystickID id = SDL_JoystickInstanceID(stick);
    for (int device = 0; device < SDL_NumJoysticks(); ++device) {
      if (SDL_JoystickGetDeviceInstanceID(device) == id) SDL_JoystickDetachVirtual(device);
    }
    SDL_JoystickClose(stick);
    std::erase(sticks, stick);
    pump();
  }
  InputRecord record() {
    pump();
    return input.record({0, 0}, {});
  }

  std::unique_ptr<PadDevices> pads;
  PlayerInput input;
  std::vector<SDL_Event> events;
  std::vector<SDL_Joystick*> sticks;
};

TEST_F(VirtualPadTest, APadThatIsConnectedInTheMiddlePlays) {
  EXPECT_EQ(pads->connected(), 0u);
  SDL_Joystick* stick = attach();
  EXPECT_EQ(pads->connected(), 1u);
  EXPECT_EQ(record(), (InputRecord{0, 0, 16384, 0}));
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTX, 32767);
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_RIGHTY, 32767);
  EXPECT_EQ(record(), (InputRecord{kStickFull, 0, 49152, kButtonFire}));
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTX, -32768);
  EXPECT_EQ(record().move_x, -kStickFull);
  SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_LEFTSHOULDER, 1);
  EXPECT_EQ(record().buttons, kButtonFire | kButtonFlush);
  SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_START, 1);
  record();
  EXPECT_TRUE(input.pressed(Action::pause));
}

TEST_F(VirtualPadTest, PulledOutItLeavesNothingPressed) {
  SDL_Joystick* stick = attach();
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTX, 32767);
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  ASSERT_EQ(record().buttons, kButtonFire);
  detach(stick);
  const InputRecord after = record();
  EXPECT_EQ(after.move_x, 0);
  EXPECT_EQ(after.move_y, 0);
  EXPECT_EQ(after.buttons, 0);
  EXPECT_TRUE(input.lostPad());
  EXPECT_EQ(pads->connected(), 0u);

  SDL_Joystick* again = attach();
  SDL_JoystickSetVirtualAxis(again, SDL_CONTROLLER_AXIS_LEFTY, -32768);
  EXPECT_EQ(record().move_y, kStickFull);
  EXPECT_FALSE(input.lostPad());
}

TEST_F(VirtualPadTest, OfTwoPadsTheOneUsedLastPlaysAndOnlyItsLossPauses) {
  SDL_Joystick *first = attach(), *second = attach();
  EXPECT_EQ(pads->connected(), 2u);
  SDL_JoystickSetVirtualAxis(first, SDL_CONTROLLER_AXIS_LEFTX, 32767);
  EXPECT_EQ(record().move_x, kStickFull);
  rest();
  SDL_JoystickSetVirtualAxis(second, SDL_CONTROLLER_AXIS_LEFTY, -32768);
  EXPECT_EQ(record(), (InputRecord{0, kStickFull, 16384, 0}));
  detach(first);
  EXPECT_FALSE(input.lostPad());
  EXPECT_EQ(record().move_y, kStickFull);
  detach(second);
  EXPECT_TRUE(input.lostPad());
}

// Under sdl2-compat its axes jump to the first values they ever had before it is gone.
TEST_F(VirtualPadTest, APadThatIsPulledOutDoesNothingOnItsWay) {
  SDL_Joystick *first = attach(), *second = attach();
  for (const int16_t value : {32767, 0}) {
    SDL_JoystickSetVirtualAxis(second, SDL_CONTROLLER_AXIS_RIGHTX, value);
    record();
  }
  rest();
  SDL_JoystickSetVirtualAxis(first, SDL_CONTROLLER_AXIS_LEFTX, 32767);
  ASSERT_EQ(record().move_x, kStickFull);
  rest();
  input.forgetPresses();
  input.menu(0);
  detach(second);
  EXPECT_EQ(record(), (InputRecord{kStickFull, 0, 0, 0})) << "the other one plays on";
  EXPECT_FALSE(input.lostPad());
  const MenuPresses presses = input.menu(0);
  EXPECT_EQ(presses.up + presses.down + presses.left + presses.right, 0);
}

TEST_F(VirtualPadTest, APadThatWasThereBeforeIsFound) {
  SDL_InitSubSystem(SDL_INIT_JOYSTICK);  // so that what is attached outlives the first PadDevices
  SDL_Joystick* stick = attach();
  pads = nullptr;
  pads = std::make_unique<PadDevices>();
  pump();
  EXPECT_EQ(pads->connected(), 1u);
  SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTX, 32767);
  EXPECT_EQ(record().move_x, kStickFull);
  detach(stick);
  SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
}

}  // namespace
}  // namespace gw
