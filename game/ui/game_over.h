// The end of a run: what was reached, what ended it, and the shortest way to the next one.
#pragma once

#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"
#include "game/ui/run_monitor.h"

namespace gw {

struct GameOverFrame {
  double time_s = 0;     // since it is shown
  uint64_t best = 0;     // of this session before this run; 0: none
  bool canRetry = true;  // false: a replay's end
  KeyHints keys{};
};

void drawGameOver(Canvas& canvas, const RunMonitor& run, const Rules& rules, const GameOverFrame& frame);

}  // namespace gw
