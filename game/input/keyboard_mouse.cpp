#include "game/input/keyboard_mouse.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace gw {

namespace {

// A stick at full deflection in one of 8 directions; diagonals are no faster.
void setMove(InputRecord& record, int x, int y) {
  const float share = (x != 0 && y != 0) ? float(std::numbers::sqrt2 / 2) : 1.0f;
  const auto full = int16_t(std::lround(float(kStickFull) * share));
  record.move_x = int16_t(x * full);
  record.move_y = int16_t(y * full);
}

}  // namespace

uint16_t quantiseAim(float angle_rad) {
  const double turns = double(angle_rad) / (2 * std::numbers::pi);
  return uint16_t(uint32_t(std::lround((turns - std::floor(turns)) * 65536.0)) & 0xffffu);
}

uint16_t quantiseAim(float x, float y, uint16_t otherwise) {
  const bool none = !(std::abs(x) > 1e-6f || std::abs(y) > 1e-6f) || !std::isfinite(x) || !std::isfinite(y);
  return none ? otherwise : quantiseAim(std::atan2(y, x));
}

void KeyboardMouse::handle(const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP: {
      const uint32_t key = uint32_t(event.key.keysym.scancode);
      const bool down = event.type == SDL_KEYDOWN;
      if (key >= keyDown_.size() || keyDown_[key] == uint8_t(down)) return;
      if (event.key.repeat != 0) return;  // of a key whose press went elsewhere
      keyDown_[key] = down;
      if (down && key >= SDL_SCANCODE_1 && key <= SDL_SCANCODE_9) number_ = key - SDL_SCANCODE_1 + 1;
      change({InputDevice::keyboard, uint16_t(key)}, down);
      return;
    }
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
      const uint32_t button = event.button.button;
      const bool down = event.type == SDL_MOUSEBUTTONDOWN;
      if (button >= buttonDown_.size() || buttonDown_[button] == uint8_t(down)) return;
      buttonDown_[button] = down;
      pointer_x_ = float(event.button.x);
      pointer_y_ = float(event.button.y);
      if (bindings_.has({InputDevice::mouse, uint16_t(button)}, Action::fire)) mouseAims_ = true;
      clicked_ |= down && button == SDL_BUTTON_LEFT;
      change({InputDevice::mouse, uint16_t(button)}, down);
      return;
    }
    case SDL_MOUSEMOTION:
      pointer_x_ = float(event.motion.x);
      pointer_y_ = float(event.motion.y);
      mouseAims_ = true;
      return;
    case SDL_MOUSEWHEEL:
      wheel_ += event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.wheel.y : event.wheel.y;
      return;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
        releaseAll();
        lostFocus_ = true;
      }
      return;
    default:
      return;
  }
}

void KeyboardMouse::setBindings(const Bindings& bindings) {
  bindings_ = bindings;
  releaseAll();
}

InputRecord KeyboardMouse::record(WorldPoint ship, WorldPoint underPointer) {
  InputRecord record;
  setMove(record, axis(Action::moveLeft, Action::moveRight), axis(Action::moveDown, Action::moveUp));
  const int aim_x = axis(Action::aimLeft, Action::aimRight), aim_y = axis(Action::aimDown, Action::aimUp);
  const bool keysAim = aim_x != 0 || aim_y != 0;
  if (keysAim) {
    mouseAims_ = false;
    aim_ = quantiseAim(float(aim_x), float(aim_y), aim_);
  } else if (mouseAims_) {
    aim_ = quantiseAim(underPointer.x - ship.x, underPointer.y - ship.y, aim_);
  }
  record.aim = aim_;
  record.buttons =
      uint16_t((keysAim || held(Action::fire) ? kButtonFire : 0) | (held(Action::flush) ? kButtonFlush : 0));
  tapped_.fill(false);
  return record;
}

bool KeyboardMouse::pressed(Action action) {
  uint32_t& count = pressedCount_[uint32_t(action)];
  if (count == 0) return false;
  --count;
  return true;
}

void KeyboardMouse::forgetPresses() {
  pressedCount_.fill(0);
  clicked_ = false;
  number_ = 0;
  wheel_ = 0;
}

uint32_t KeyboardMouse::number() {
  return std::exchange(number_, 0);
}

int KeyboardMouse::wheel() {
  return std::exchange(wheel_, 0);
}

bool KeyboardMouse::clicked() {
  return std::exchange(clicked_, false);
}

void KeyboardMouse::beginPlay() {
  tapped_.fill(false);
  heldKeys_[uint32_t(Action::flush)] = 0;
}

void KeyboardMouse::releaseAll() {
  keyDown_.fill(0);
  buttonDown_.fill(0);
  heldKeys_.fill(0);
  tapped_.fill(false);
}

bool KeyboardMouse::lostFocus() {
  const bool lost = lostFocus_;
  lostFocus_ = false;
  return lost;
}

void KeyboardMouse::aimedElsewhere(uint16_t aim) {
  mouseAims_ = false;
  aim_ = aim;
}

void KeyboardMouse::change(Control control, bool down) {
  for (uint32_t i = 0; i < kActions; ++i) {
    if (bindings_.has(control, Action(i))) down ? press(Action(i)) : release(Action(i));
  }
}

void KeyboardMouse::press(Action action) {
  const uint32_t i = uint32_t(action);
  ++heldKeys_[i];
  tapped_[i] = true;
  ++pressedCount_[i];
  pressedAt_[i] = ++presses_;
}

void KeyboardMouse::release(Action action) {
  uint32_t& keys = heldKeys_[uint32_t(action)];
  if (keys > 0) --keys;
}

int KeyboardMouse::axis(Action negative, Action positive) const {
  const bool minus = held(negative), plus = held(positive);
  if (minus && plus) return pressedAt_[uint32_t(positive)] > pressedAt_[uint32_t(negative)] ? 1 : -1;
  return int(plus) - int(minus);
}

}  // namespace gw
