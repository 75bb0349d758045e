// Practice: what is asked for next and by which keys, and what there is to know of one enemy.
#pragma once

#include <optional>

#include "game/sim/simulation.h"
#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"

namespace gw {

struct PracticeFrame {
  uint32_t type = 0;
  uint32_t count = 1;
  bool slow = false;
  bool keysShown = true;  // false: a recorded practice, in a replay
  KeyHints keys{};
};

void drawPracticePanel(Canvas& canvas, const Rules& rules, const PracticeFrame& frame);

// An enemy that was clicked on, and where it is on the canvas.
struct Inspected {
  EntityRecord entity;
  float x, y;
};

// The pause of practice: the world stays visible, so that it can be looked at. `inspected` may be none.
void drawPracticePause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad,
                       const std::optional<Inspected>& inspected);

}  // namespace gw
