#include "game/input/player_input.h"

#include <cmath>

namespace gw {

namespace {

// Two moves at once, within the unit disc.
void addMove(InputRecord& record, Stick stick) {
  const float x = float(record.move_x) / kStickFull + stick.x, y = float(record.move_y) / kStickFull + stick.y;
  const float length = std::sqrt(x * x + y * y);
  const float share = length > 1 ? 1 / length : 1.0f;
  record.move_x = quantiseStick(x * share);
  record.move_y = quantiseStick(y * share);
}

SDL_JoystickID padOf(const SDL_Event& event) {
  return event.type == SDL_CONTROLLERAXISMOTION ? event.caxis.which : event.cbutton.which;
}

}  // namespace

PlayerInput::PlayerInput(const Bindings& bindings) : keys_(withFallBacks(bindings)), pad_(withFallBacks(bindings)) {}

void PlayerInput::setBindings(const Bindings& bindings) {
  keys_.setBindings(withFallBacks(bindings));
  pad_.setBindings(withFallBacks(bindings));
}

void PlayerInput::handle(const SDL_Event& event) {
  if (listening_ && hear(event)) return;
  menu_.handle(event, arbiter_);
  keys_.handle(event);
  pad_.handle(event, arbiter_);
  if (event.type == SDL_KEYDOWN || event.type == SDL_MOUSEBUTTONDOWN) padInUse_ = false;
  if (event.type == SDL_CONTROLLERBUTTONDOWN || event.type == SDL_CONTROLLERAXISMOTION) {
    const Stick move = pad_.move(), aim = pad_.aim();
    const bool used = event.type == SDL_CONTROLLERBUTTONDOWN || move.x != 0 || move.y != 0 || aim.x != 0 || aim.y != 0;
    padInUse_ |= used && pad_.plays();
  }
  if (pad_.lost()) {
    lostPad_ |= padInUse_;  // a pad laid aside for the keyboard is not missed
    if (padInUse_) keys_.releaseAll();
    padInUse_ = false;
  }
  if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) pad_.releaseAll();
}

InputRecord PlayerInput::record(WorldPoint ship, WorldPoint underPointer) {
  const auto cross = [&](Action negative, Action positive) {
    return float(int(pad_.held(positive)) - int(pad_.held(negative)));
  };
  Stick aim = pad_.aim();
  if (aim.x == 0 && aim.y == 0) {
    aim = {cross(Action::aimLeft, Action::aimRight), cross(Action::aimDown, Action::aimUp)};
  }
  const bool padAims = aim.x != 0 || aim.y != 0;
  InputRecord record = keys_.record(ship, underPointer);
  if (padAims) {
    record.aim = quantiseAim(aim.x, aim.y, record.aim);
    keys_.aimedElsewhere(record.aim);
  }
  Stick move = pad_.move();
  move.x += cross(Action::moveLeft, Action::moveRight);
  move.y += cross(Action::moveDown, Action::moveUp);
  if (move.x != 0 || move.y != 0) addMove(record, move);
  if (padAims || pad_.held(Action::fire)) record.buttons |= kButtonFire;
  if (pad_.held(Action::flush)) record.buttons |= kButtonFlush;
  pad_.recorded();
  return record;
}

bool PlayerInput::pressed(Action action) {
  return keys_.pressed(action) || pad_.pressed(action);
}

void PlayerInput::beginPlay() {
  forgetPresses();
  keys_.beginPlay();
  pad_.beginPlay();
}

void PlayerInput::forgetPresses() {
  keys_.forgetPresses();
  pad_.forgetPresses();
}

bool PlayerInput::lostFocus() {
  return keys_.lostFocus();
}

bool PlayerInput::lostPad() {
  const bool lost = lostPad_;
  lostPad_ = false;
  return lost;
}

void PlayerInput::listen() {
  listening_ = true;
  heard_.reset();
}

std::optional<Control> PlayerInput::heard() {
  const std::optional<Control> control = heard_;
  heard_.reset();
  return control;
}

// True when the event was a press that is kept instead of acted on.
bool PlayerInput::hear(const SDL_Event& event) {
  std::optional<Control> control;
  if (event.type == SDL_KEYDOWN) {
    if (event.key.repeat != 0) return true;
    const uint32_t key = uint32_t(event.key.keysym.scancode);
    if (key == kKeyEscape || key == 0 || key >= kKeys) return false;
    control = Control{InputDevice::keyboard, uint16_t(key)};
  } else if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button < kMouseButtons) {
    control = Control{InputDevice::mouse, event.button.button};
  } else {
    control = pad_.pressedBy(event);
    if (control && !arbiter_.press(padOf(event), event.common.timestamp)) return false;  // and acts on nothing either
  }
  if (!control) return false;
  heard_ = control;
  listening_ = false;
  return true;
}

}  // namespace gw
