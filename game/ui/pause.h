// Pause: what the keys do from here, and what there is to fear.
#pragma once

#include "game/sim/rules.h"
#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"

namespace gw {

struct PauseFrame {
  bool lostPad = false;  // because the controller in use went away
  KeyHints keys{};
};

void drawPause(Canvas& canvas, const Rules& rules, const PauseFrame& frame);

}  // namespace gw
