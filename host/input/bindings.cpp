#include "host/input/bindings.h"

#include <algorithm>

namespace gw {

namespace {

// USB usage numbers of the keyboard page.
constexpr uint16_t letter(char c) {
  return uint16_t(4 + c - 'A');
}
constexpr uint16_t kTab = 43, kSpace = 44, kMinus = 45, kEquals = 46, kF11 = 68, kPauseKey = 72, kRight = 79,
                   kLeft = 80, kDown = 81, kUp = 82, kKeypadMinus = 86, kKeypadPlus = 87, kKeypadEnter = 88,
                   kLeftShift = 225;

constexpr std::string_view kNames[] = {"move_up",  "move_down", "move_left", "move_right", "aim_up",     "aim_down",
                                       "aim_left", "aim_right", "fire",      "flush",      "pause",      "confirm",
                                       "retry",    "quit",      "settings",  "fullscreen", "mute",       "spawn",
                                       "clear",    "next_type", "more",      "fewer",      "slow_motion"};
static_assert(std::size(kNames) == kActions);

}  // namespace

std::string_view actionName(Action action) {
  return kNames[uint32_t(action)];
}

Bindings::Bindings() {
  const auto keys = [&](Action action, std::vector<uint16_t> list) {
    codes(InputDevice::keyboard, action) = std::move(list);
  };
  const auto mouse = [&](Action action, std::vector<uint16_t> list) {
    codes(InputDevice::mouse, action) = std::move(list);
  };
  const auto pad = [&](Action action, std::vector<uint16_t> list) {
    codes(InputDevice::pad, action) = std::move(list);
  };
  keys(Action::moveUp, {letter('W')});
  keys(Action::moveDown, {letter('S')});
  keys(Action::moveLeft, {letter('A')});
  keys(Action::moveRight, {letter('D')});
  keys(Action::aimUp, {kUp});
  keys(Action::aimDown, {kDown});
  keys(Action::aimLeft, {kLeft});
  keys(Action::aimRight, {kRight});
  keys(Action::flush, {kSpace, kLeftShift});
  keys(Action::pause, {kKeyEscape, letter('P'), kPauseKey});
  keys(Action::confirm, {kKeyEnter, kSpace, kKeypadEnter});
  keys(Action::retry, {letter('R')});
  keys(Action::quit, {letter('Q')});
  keys(Action::settings, {letter('O')});
  keys(Action::fullscreen, {letter('F'), kF11});
  keys(Action::mute, {letter('M')});
  keys(Action::spawn, {letter('N')});
  keys(Action::clear, {letter('C')});
  keys(Action::nextType, {kTab});
  keys(Action::more, {kEquals, kKeypadPlus});
  keys(Action::fewer, {kMinus, kKeypadMinus});
  keys(Action::slowMotion, {letter('T')});
  mouse(Action::fire, {1});
  mouse(Action::confirm, {1});
  mouse(Action::flush, {3});
  // The sticks move, aim and fire without being asked for here.
  pad(Action::moveUp, {kPadUp});
  pad(Action::moveDown, {kPadDown});
  pad(Action::moveLeft, {kPadLeft});
  pad(Action::moveRight, {kPadRight});
  pad(Action::flush, {kPadLeftTrigger, kPadRightTrigger, kPadLeftShoulder, kPadRightShoulder});
  pad(Action::pause, {kPadStart});
  pad(Action::confirm, {kPadA, kPadStart});
  pad(Action::retry, {kPadX});
  pad(Action::quit, {kPadB, kPadBack});
  pad(Action::settings, {kPadY});
  // The cross moves the ship, so practice takes what else only menus use.
  pad(Action::spawn, {kPadY});
  pad(Action::clear, {kPadBack});
  pad(Action::nextType, {kPadX});
  pad(Action::more, {kPadA});
  pad(Action::fewer, {kPadB});
  pad(Action::slowMotion, {kPadRightStick});
}

bool Bindings::has(Control control, Action action) const {
  const std::vector<uint16_t>& list = codes(control.device, action);
  return std::find(list.begin(), list.end(), control.code) != list.end();
}

Bindings withFallBacks(Bindings bindings) {
  const auto atLeast = [&](InputDevice device, uint16_t code) {
    std::vector<uint16_t>& list = bindings.codes(device, Action::pause);
    if (list.empty()) list.push_back(code);
  };
  atLeast(InputDevice::keyboard, kKeyEscape);
  atLeast(InputDevice::pad, kPadStart);
  return bindings;
}

}  // namespace gw
