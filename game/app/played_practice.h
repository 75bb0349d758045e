// A practice that somebody plays in a window: what its keys choose, the look into an enemy, and its screens.
#pragma once

#include <optional>

#include "game/app/game_loop.h"
#include "game/app/screen_flow.h"
#include "game/session/practice.h"
#include "game/ui/key_hints.h"

namespace gw {

class PlayedPractice {
 public:
  explicit PlayedPractice(uint32_t typeCount) : practice_(typeCount) {}

  // The presses of a frame, before whatever is left of them is forgotten. In the pause a click looks at an enemy.
  void take(PlayerInput& keys);
  // After the flow of the frame has said which screen is shown.
  void step(Screen screen, GameLoop& loop, Run& run);
  uint16_t takeButtons() { return practice_.takeButtons(); }  // for the next record

  void drawPanel(Canvas& canvas, const Rules& rules, const KeyHints& keys) const;
  void drawPause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad, const GameLoop& loop) const;

 private:
  Practice practice_;
  PracticePresses presses_;  // of this frame
  bool clicked_ = false;
  std::optional<EntityRecord> inspected_;  // until play goes on
};

}  // namespace gw
