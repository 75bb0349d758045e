// Practice mode in a window: its keys, the inspection of an enemy in the pause, and its screens.
#pragma once

#include <optional>

#include "game/app/app_services.h"
#include "game/app/screen_flow.h"
#include "game/session/practice.h"
#include "game/ui/key_hints.h"

namespace gw {

class PracticeControls {
 public:
  explicit PracticeControls(uint32_t typeCount) : practice_(typeCount) {}

  // Takes the presses of a frame, before PlayerInput forgets them.
  void take(PlayerInput& keys);
  // Once the frame's screen is known. In the pause a click inspects the enemy at `pointer`.
  void update(Screen screen, FixedTimestep& timestep, Run& run, WorldPoint pointer);
  uint16_t takeButtons() { return practice_.takeButtons(); }  // for the next record

  void drawPanel(Canvas& canvas, const Rules& rules, const KeyHints& keys) const;
  void drawPause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad,
                 const AppServices& services) const;

 private:
  Practice practice_;
  PracticePresses presses_;  // of this frame
  bool clicked_ = false;
  std::optional<EntityRecord> inspected_;  // until the run continues
};

}  // namespace gw
