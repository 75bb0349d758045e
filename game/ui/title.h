// The title: the name in neon over a game that plays itself. Any start key starts the chosen mode at once.
#pragma once

#include <string>

#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"
#include "game/ui/mode_choice.h"

namespace gw {

struct TitleFrame {
  double time_s = 0;         // since it is shown
  std::string device;        // what simulates, e.g. "cpu, 2 threads"
  uint32_t enemies = 0;      // that fit
  Mode mode = Mode::arcade;  // chosen
  std::string best;          // of this session in that mode; empty: none
  KeyHints keys{};
};

void drawTitle(Canvas& canvas, const TitleFrame& frame);

}  // namespace gw
