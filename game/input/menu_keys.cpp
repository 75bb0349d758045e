#include "game/input/menu_keys.h"

#include <cmath>

#include "game/input/bindings.h"
#include "game/input/gamepad.h"

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

void MenuKeys::step(Direction direction) {
  presses_.up += direction.y < 0;
  presses_.down += direction.y > 0;
  presses_.left += direction.x < 0;
  presses_.right += direction.x > 0;
}

void MenuKeys::handle(const SDL_Event& event) {
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
    case SDL_CONTROLLERBUTTONUP: {
      const uint16_t button = event.cbutton.button;
      const bool down = event.type == SDL_CONTROLLERBUTTONDOWN;
      const Direction before = cross_;
      if (button == kPadUp) cross_.y = down ? -1 : 0;
      if (button == kPadDown) cross_.y = down ? 1 : 0;
      if (button == kPadLeft) cross_.x = down ? -1 : 0;
      if (button == kPadRight) cross_.x = down ? 1 : 0;
      if (down && !(cross_ == before)) step({cross_.x != before.x ? cross_.x : 0, cross_.y != before.y ? cross_.y : 0});
      presses_.confirm |= down && button == kPadA;
      presses_.back |= down && button == kPadB;
      presses_.otherColumn |= down && (button == kPadLeftShoulder || button == kPadRightShoulder);
      return;
    }
    case SDL_CONTROLLERAXISMOTION: {
      const Direction before = stick_;
      const float share = axisShare(event.caxis.value);
      if (event.caxis.axis == SDL_CONTROLLER_AXIS_LEFTX) stick_.x = pushed(share, stick_.x);
      if (event.caxis.axis == SDL_CONTROLLER_AXIS_LEFTY) stick_.y = pushed(share, stick_.y);
      step({stick_.x != before.x ? stick_.x : 0, stick_.y != before.y ? stick_.y : 0});
      return;
    }
    case SDL_CONTROLLERDEVICEREMOVED:
      stick_ = cross_ = {};
      return;
    default:
      return;
  }
}

MenuPresses MenuKeys::take(double now_s) {
  const Direction held = cross_ == Direction{} ? stick_ : cross_;
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
