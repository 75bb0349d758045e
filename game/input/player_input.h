// Keyboard, mouse and game controllers as one player.
//
// Moves add up and stay within the unit disc, so no player has to choose a device. The aim belongs to who aimed
// last: a deflected stick overrules the arrow keys, both overrule the mouse until it moves again.
#pragma once

#include <SDL_events.h>

#include <optional>

#include "game/input/gamepad.h"
#include "game/input/keyboard_mouse.h"
#include "game/input/menu_keys.h"

namespace gw {

class PlayerInput {
 public:
  explicit PlayerInput(const Bindings& bindings = {});

  void handle(const SDL_Event& event);
  // All events of a frame were handled, which SDL began to collect at this time of its clock.
  void endFrame(uint32_t now_ms) { arbiter_.looked(now_ms); }

  // What is bound from now on, but for a pause that could not be reached (withFallBacks); what is held counts as
  // released.
  void setBindings(const Bindings& bindings);
  void setDeadZones(float move, float aim) { pad_.setDeadZones(move, aim); }

  // The record for the next tick; the mouse aims from the ship at what lies under the pointer.
  InputRecord record(WorldPoint ship, WorldPoint underPointer);

  // True once per press.
  bool pressed(Action action);
  MenuPresses menu(double now_s) { return menu_.take(now_s); }
  // Forgets presses that were not asked for, so that none acts on the next screen.
  void forgetPresses();
  // Play begins or goes on: what was tapped in a menu is forgotten, and a key that flushes must be pressed again. A
  // held move goes on.
  void beginPlay();

  // Number keys, wheel and left button mean these whatever is bound to them; see keyboard_mouse.h.
  uint32_t number() { return keys_.number(); }
  int wheel() { return keys_.wheel(); }
  bool clicked() { return keys_.clicked(); }

  // True once after the window lost the focus.
  bool lostFocus();
  // True once after the pad that was in use went away; everything is released then.
  bool lostPad();
  // Whether a pad's button or stick was the last thing pressed.
  bool padInUse() const { return padInUse_; }

  // The next key or button acts on nothing and is kept for heard(). Escape comes out of menu() only.
  void listen();
  bool listening() const { return listening_; }
  void stopListening() { listening_ = false; }
  std::optional<Control> heard();

  float pointer_x_px() const { return keys_.pointer_x_px(); }
  float pointer_y_px() const { return keys_.pointer_y_px(); }
  bool aimsByMouse() const { return keys_.aimsByMouse(); }

 private:
  bool hear(const SDL_Event& event);

  KeyboardMouse keys_;
  Gamepad pad_;
  MenuKeys menu_;
  PadArbiter arbiter_;
  bool padInUse_ = false, lostPad_ = false;
  bool listening_ = false;
  std::optional<Control> heard_;
};

}  // namespace gw
