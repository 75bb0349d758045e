#include "game/input/gamepad.h"

#include <algorithm>
#include <cmath>

namespace gw {

namespace {

// A trigger is a button that goes down here and up there; between the two it stays as it is.
constexpr int16_t kTriggerDown = 16384, kTriggerUp = 12288;
// How far a stick must go for its pad to take over: farther than any pad drifts that lies on a table.
constexpr float kTakesOver = 0.5f;

uint16_t triggerButton(uint8_t axis) {
  return axis == SDL_CONTROLLER_AXIS_TRIGGERLEFT ? kPadLeftTrigger : kPadRightTrigger;
}

bool isTrigger(uint8_t axis) {
  return axis == SDL_CONTROLLER_AXIS_TRIGGERLEFT || axis == SDL_CONTROLLER_AXIS_TRIGGERRIGHT;
}

}  // namespace

float axisShare(int16_t raw) {
  return raw <= -32767 ? -1.0f : float(raw) / 32767.0f;
}

Stick shapeStick(float x, float y, float deadZone) {
  if (!std::isfinite(x) || !std::isfinite(y)) return {};
  x = std::clamp(x, -1.0f, 1.0f);
  y = std::clamp(y, -1.0f, 1.0f);
  const float length = std::sqrt(x * x + y * y);
  if (!(length > deadZone) || length == 0) return {};
  const float share = std::min((length - deadZone) / (1 - deadZone), 1.0f);
  return {x / length * share, y / length * share};
}

int16_t quantiseStick(float component) {
  if (!std::isfinite(component)) return 0;
  return int16_t(std::lround(std::clamp(component, -1.0f, 1.0f) * float(kStickFull)));
}

void Gamepad::handle(const SDL_Event& event, PadArbiter& turns) {
  switch (event.type) {
    case SDL_CONTROLLERAXISMOTION:
      moveAxis(event.caxis, turns);
      return;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP: {
      if (event.cbutton.button >= kPadLeftTrigger) return;
      Pad& from = pad(event.cbutton.which);
      const bool pressed = setButton(from, event.cbutton.button, event.type == SDL_CONTROLLERBUTTONDOWN);
      if (pressed && turns.press(from.id, event.cbutton.timestamp)) press(from, event.cbutton.button);
      return;
    }
    case SDL_CONTROLLERDEVICEREMOVED: {
      const SDL_JoystickID id = event.cdevice.which;
      std::erase_if(pads_, [&](const Pad& pad) { return pad.id == id; });
      turns.forget(id);
      if (playing_ == id) {
        playing_.reset();
        tapped_.fill(false);
        lost_ = true;
      }
      return;
    }
    default:
      return;
  }
}

void Gamepad::moveAxis(const SDL_ControllerAxisEvent& event, PadArbiter& turns) {
  Pad& from = pad(event.which);
  if (isTrigger(event.axis)) {
    const uint16_t button = triggerButton(event.axis);
    const bool pressed = setButton(from, button, event.value >= (from.down[button] ? kTriggerUp : kTriggerDown));
    if (pressed && turns.press(from.id, event.timestamp)) press(from, button);
  } else if (event.axis < from.sticks.size()) {
    int16_t& stick = from.sticks[event.axis];
    const bool was = std::abs(axisShare(stick)) > kTakesOver, is = std::abs(axisShare(event.value)) > kTakesOver;
    stick = event.value;
    // Pushing it is a press; a stick that is held out moves all the time, and keeps no other pad from pressing.
    if (is && (was ? turns.mayPress(from.id, event.timestamp) : turns.press(from.id, event.timestamp))) use(from);
  }
}

void Gamepad::setBindings(const Bindings& bindings) {
  bindings_ = bindings;
  releaseAll();
}

void Gamepad::setDeadZones(float move, float aim) {
  moveDeadZone_ = move;
  aimDeadZone_ = aim;
}

Stick Gamepad::move() const {
  const Pad* pad = playing();
  return pad ? shapeStick(axisShare(pad->sticks[0]), -axisShare(pad->sticks[1]), moveDeadZone_) : Stick{};
}

Stick Gamepad::aim() const {
  const Pad* pad = playing();
  return pad ? shapeStick(axisShare(pad->sticks[2]), -axisShare(pad->sticks[3]), aimDeadZone_) : Stick{};
}

bool Gamepad::held(Action action) const {
  if (tapped_[uint32_t(action)]) return true;
  const Pad* pad = playing();
  if (!pad) return false;
  const std::vector<uint16_t>& codes = bindings_.codes(InputDevice::pad, action);
  return std::any_of(codes.begin(), codes.end(), [&](uint16_t code) { return code < kPadButtons && pad->down[code]; });
}

bool Gamepad::pressed(Action action) {
  uint32_t& count = pressedCount_[uint32_t(action)];
  if (count == 0) return false;
  --count;
  return true;
}

void Gamepad::beginPlay() {
  tapped_.fill(false);
  for (Pad& pad : pads_) {
    for (const uint16_t code : bindings_.codes(InputDevice::pad, Action::flush)) {
      if (code < kPadButtons) pad.down[code] = false;
    }
  }
}

void Gamepad::releaseAll() {
  for (Pad& pad : pads_) {
    pad.sticks.fill(0);
    pad.down.fill(false);
  }
  tapped_.fill(false);
}

bool Gamepad::lost() {
  const bool lost = lost_;
  lost_ = false;
  return lost;
}

std::optional<Control> Gamepad::pressedBy(const SDL_Event& event) const {
  if (event.type == SDL_CONTROLLERBUTTONDOWN && event.cbutton.button < kPadLeftTrigger) {
    return Control{InputDevice::pad, event.cbutton.button};
  }
  if (event.type == SDL_CONTROLLERAXISMOTION && isTrigger(event.caxis.axis) && event.caxis.value >= kTriggerDown) {
    const Pad* from = find(event.caxis.which);
    const uint16_t button = triggerButton(event.caxis.axis);
    if (!from || !from->down[button]) return Control{InputDevice::pad, button};
  }
  return std::nullopt;
}

Gamepad::Pad& Gamepad::pad(SDL_JoystickID id) {
  for (Pad& pad : pads_) {
    if (pad.id == id) return pad;
  }
  pads_.push_back({id, {}, {}});
  return pads_.back();
}

const Gamepad::Pad* Gamepad::find(SDL_JoystickID id) const {
  const auto found = std::find_if(pads_.begin(), pads_.end(), [&](const Pad& pad) { return pad.id == id; });
  return found == pads_.end() ? nullptr : &*found;
}

void Gamepad::use(const Pad& pad) {
  playing_ = pad.id;
}

bool Gamepad::setButton(Pad& pad, uint16_t button, bool down) {
  const bool changed = pad.down[button] != down;
  pad.down[button] = down;
  return changed && down;
}

void Gamepad::press(const Pad& pad, uint16_t button) {
  use(pad);
  for (uint32_t i = 0; i < kActions; ++i) {
    if (!bindings_.has({InputDevice::pad, button}, Action(i))) continue;
    tapped_[i] = true;
    ++pressedCount_[i];
  }
}

}  // namespace gw
