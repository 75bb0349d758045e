#include "game/input/menu_keys.h"

#include <algorithm>
#include <cmath>

#include "game/input/gamepad.h"
#include "host/input/bindings.h"

namespace gw {

namespace {

constexpr double kFirstRepeat_s = 0.4, kNextRepeat_s = 0.08;
// A stick counts as pushed here and as let go there; between the two it stays as it is.
constexpr float kPushed = 0.6f, kLetGo = 0.4f;

int pushed(float share, int before) {
  if (std::abs(share) >= kPushed) return share > 0 ? 1 : -1;
  return std::abs(share) <= kLetGo ? 0 : before;
}

}  // namespace

// What is newly pushed.
MenuKeys::Direction MenuKeys::changed(Direction before, Direction now) {
  return {now.x != before.x ? now.x : 0, now.y != before.y ? now.y : 0};
}

void MenuKeys::step(Direction direction) {
  presses_.up += direction.y < 0;
  presses_.down += direction.y > 0;
  presses_.left += direction.x < 0;
  presses_.right += direction.x > 0;
}

void MenuKeys::handle(const SDL_Event& event, PadArbiter& turns) {
  switch (event.type) {
    case SDL_KEYDOWN: {
      const SDL_Scancode key = event.key.keysym.scancode;
      if (key == SDL_SCANCODE_UP) step({0, -1});
      if (key == SDL_SCANCODE_DOWN) step({0, 1});
      if (key == SDL_SCANCODE_LEFT) step({-1, 0});
      if (key == SDL_SCANCODE_RIGHT) step({1, 0});
      if (event.key.repeat != 0) return;
      presses_.confirm |= key == SDL_SCANCODE_RETURN || key == SDL_SCANCODE_KP_ENTER;
      presses_.escape |= key == SDL_SCANCODE_ESCAPE;
      presses_.back |= key == SDL_SCANCODE_ESCAPE;
      presses_.otherColumn |= key == SDL_SCANCODE_TAB;
      return;
    }
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      return pressButton(event.cbutton, turns);
    case SDL_CONTROLLERAXISMOTION:
      return moveStick(event.caxis, turns);
    case SDL_CONTROLLERDEVICEREMOVED:
      std::erase_if(pads_, [&](const Pad& pad) { return pad.id == event.cdevice.which; });
      if (last_ == event.cdevice.which) last_.reset();
      return;
    default:
      return;
  }
}

void MenuKeys::pressButton(const SDL_ControllerButtonEvent& event, PadArbiter& turns) {
  Pad& from = pad(event.which);
  const uint16_t button = event.button;
  const bool down = event.type == SDL_CONTROLLERBUTTONDOWN;
  const Direction before = from.cross;
  if (button == kPadUp) from.cross.y = down ? -1 : 0;
  if (button == kPadDown) from.cross.y = down ? 1 : 0;
  if (button == kPadLeft) from.cross.x = down ? -1 : 0;
  if (button == kPadRight) from.cross.x = down ? 1 : 0;
  if (!down || !turns.press(from.id, event.timestamp)) return;
  last_ = from.id;
  step(changed(before, from.cross));
  presses_.confirm |= button == kPadA;
  presses_.back |= button == kPadB;
  presses_.otherColumn |= button == kPadLeftShoulder || button == kPadRightShoulder;
}

void MenuKeys::moveStick(const SDL_ControllerAxisEvent& event, PadArbiter& turns) {
  Pad& from = pad(event.which);
  const Direction before = from.stick;
  const float share = axisShare(event.value);
  if (event.axis == SDL_CONTROLLER_AXIS_LEFTX) from.stick.x = pushed(share, from.stick.x);
  if (event.axis == SDL_CONTROLLER_AXIS_LEFTY) from.stick.y = pushed(share, from.stick.y);
  const Direction push = changed(before, from.stick);
  if (push == Direction{} || !turns.press(from.id, event.timestamp)) return;
  last_ = from.id;
  step(push);
}

MenuKeys::Pad& MenuKeys::pad(SDL_JoystickID id) {
  const auto found = std::find_if(pads_.begin(), pads_.end(), [&](const Pad& pad) { return pad.id == id; });
  if (found != pads_.end()) return *found;
  return pads_.emplace_back(Pad{id, {}, {}});
}

MenuKeys::Direction MenuKeys::held() const {
  for (const Pad& pad : pads_) {
    if (pad.id == last_) return pad.cross == Direction{} ? pad.stick : pad.cross;
  }
  return {};
}

MenuPresses MenuKeys::take(double now_s) {
  const Direction held = this->held();
  if (!(held == repeated_)) {
    repeated_ = held;
    repeatAt_s_ = now_s + kFirstRepeat_s;
  } else if (!(held == Direction{}) && now_s >= repeatAt_s_) {
    step(held);
    repeatAt_s_ = now_s + kNextRepeat_s;
  }
  const MenuPresses taken = presses_;
  presses_ = {};
  return taken;
}

}  // namespace gw
