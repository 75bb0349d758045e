// Game controllers, from SDL's events only: which one plays, where its sticks stand, what its buttons do.
// Opening and closing the devices is pad_devices.h's; this knows a pad by the events it sends.
#pragma once

#include <SDL_events.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "game/sim/input_record.h"
#include "host/input/bindings.h"
#include "host/input/pad_arbiter.h"

namespace gw {

struct Stick {
  float x = 0, y = 0;  // x right, y up
};

// SDL's axis value as a share of full deflection, -1 to 1; -32768 is -1 like -32767.
float axisShare(int16_t raw);

// What the game takes from a stick. Within `deadZone` (a share of full deflection) of the centre it is exactly 0;
// from there the length grows from 0 to 1, in the stick's own direction, and nothing leaves the unit disc, whatever
// square the hardware reports. What is not a finite number counts as an untouched stick.
Stick shapeStick(float x, float y, float deadZone);

// A component from -1 to 1 as an InputRecord holds it: to the nearest step, symmetric; -32768 never comes out.
int16_t quantiseStick(float component);

class Gamepad {
 public:
  explicit Gamepad(const Bindings& bindings = {}) : bindings_(bindings) {}

  // Pads appear with their first event and go with SDL_CONTROLLERDEVICEREMOVED. The pad that was used last plays: a
  // button, a trigger, or a stick more than half way out. Only its sticks and buttons count. A press out of turn is
  // none.
  void handle(const SDL_Event& event, PadArbiter& turns);

  void setBindings(const Bindings& bindings);
  void setDeadZones(float move, float aim);

  Stick move() const;  // shaped
  Stick aim() const;   // shaped; (0, 0) aims nowhere
  bool held(Action action) const;
  // Taps between two records count for one.
  void recorded() { tapped_.fill(false); }

  // True once per press.
  bool pressed(Action action);
  void forgetPresses() { pressedCount_.fill(0); }

  // Forgets taps and the hold on flush: the button that starts a run does not flush in it.
  void beginPlay();

  // Neutral until something moves again: what is held now counts as released.
  void releaseAll();

  bool plays() const { return playing_.has_value(); }
  // True once after the pad that plays went away.
  bool lost();

  // The button that `event` presses, triggers included.
  std::optional<Control> pressedBy(const SDL_Event& event) const;

 private:
  struct Pad {
    SDL_JoystickID id = 0;
    std::array<int16_t, 4> sticks{};  // as SDL_CONTROLLER_AXIS_LEFTX to RIGHTY
    std::array<bool, kPadButtons> down{};
  };
  Pad& pad(SDL_JoystickID id);
  const Pad* find(SDL_JoystickID id) const;
  const Pad* playing() const { return playing_ ? find(*playing_) : nullptr; }
  void use(const Pad& pad);
  // True when that is a press.
  static bool setButton(Pad& pad, uint16_t button, bool down);
  void press(const Pad& pad, uint16_t button);
  void moveAxis(const SDL_ControllerAxisEvent& event, PadArbiter& turns);

  Bindings bindings_;
  float moveDeadZone_ = 0.2f, aimDeadZone_ = 0.25f;
  std::vector<Pad> pads_;
  std::optional<SDL_JoystickID> playing_;
  std::array<bool, kActions> tapped_{};
  std::array<uint32_t, kActions> pressedCount_{};
  bool lost_ = false;
};

}  // namespace gw
