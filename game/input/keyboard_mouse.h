// Turns the window's keyboard and mouse events into the one small record a tick that the simulation
// takes. It reads events only, never the state of the keyboard: pushed and real events then mean the same.
#pragma once

#include <SDL_events.h>

#include <array>
#include <cstdint>

#include "game/sim/input_record.h"
#include "host/input/bindings.h"

namespace gw {

struct WorldPoint {
  float x = 0, y = 0;  // metres, y up
};

// An angle in radians as an InputRecord holds it: 1/65536 turns, counter-clockwise from +x.
uint16_t quantiseAim(float angle_rad);
// The same from a direction; (0, 0) gives `otherwise`.
uint16_t quantiseAim(float x, float y, uint16_t otherwise);

class KeyboardMouse {
 public:
  explicit KeyboardMouse(const Bindings& bindings = {}) : bindings_(bindings) {}

  void handle(const SDL_Event& event);

  // Other keys from now on; what is held counts as released.
  void setBindings(const Bindings& bindings);

  // The record for the next tick. The mouse aims from the ship at what lies under the pointer; held
  // arrow keys overrule it until the mouse moves again without them. A tap between two ticks counts for
  // one tick.
  InputRecord record(WorldPoint ship, WorldPoint underPointer);

  // True once per press of the key (repeats do not count).
  bool pressed(Action action);
  // Forgets presses that were not asked for, so that none acts on the next screen.
  void forgetPresses();

  // Forgets taps and the hold on flush: the space that starts a run does not flush in it.
  void beginPlay();

  // Releases everything: keys let go elsewhere send no event here.
  void releaseAll();
  // True once after the window lost the focus.
  bool lostFocus();

  // Since the last call: the number key from 1 to 9 that was pressed last, or 0.
  uint32_t number();
  // Since the last call: steps of the wheel away from the player, less those towards him.
  int wheel();
  // Since the last call: whether the left button was pressed.
  bool clicked();

  float pointer_x_px() const { return pointer_x_; }
  float pointer_y_px() const { return pointer_y_; }
  bool aimsByMouse() const { return mouseAims_; }
  // Something else aimed: the mouse takes the aim back when it moves.
  void aimedElsewhere(uint16_t aim);

 private:
  void change(Control control, bool down);
  void press(Action action);
  void release(Action action);
  bool held(Action action) const { return heldKeys_[uint32_t(action)] > 0 || tapped_[uint32_t(action)]; }
  int axis(Action negative, Action positive) const;

  Bindings bindings_;
  std::array<uint8_t, kKeys> keyDown_{};  // repeats and doubled events do not count twice
  std::array<uint8_t, kMouseButtons> buttonDown_{};
  std::array<uint32_t, kActions> heldKeys_{};  // how many keys hold it
  std::array<bool, kActions> tapped_{};        // pressed since the last record
  std::array<uint32_t, kActions> pressedCount_{};
  std::array<uint64_t, kActions> pressedAt_{};  // order of presses: of two opposite keys the later wins
  uint64_t presses_ = 0;
  float pointer_x_ = 0, pointer_y_ = 0;
  bool mouseAims_ = false;
  bool lostFocus_ = false, clicked_ = false;
  uint32_t number_ = 0;
  int wheel_ = 0;
  uint16_t aim_ = 16384;  // up, until the player aims
};

}  // namespace gw
