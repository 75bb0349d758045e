// The real path from SDL's joystick layer to the record, with a controller that SDL makes up: attached while the
// game runs, used, and pulled out.
#include <SDL.h>
#include <gtest/gtest.h>

#include "game/input/pad_devices.h"
#include "game/input/player_input.h"

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
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
      pads->handle(event);
      input.handle(event);
    }
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
  SDL_JoystickSetVirtualAxis(second, SDL_CONTROLLER_AXIS_LEFTY, -32768);
  EXPECT_EQ(record(), (InputRecord{0, kStickFull, 16384, 0}));
  detach(first);
  EXPECT_FALSE(input.lostPad());
  EXPECT_EQ(record().move_y, kStickFull);
  detach(second);
  EXPECT_TRUE(input.lostPad());
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
