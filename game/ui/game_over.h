// The end of a run: what was reached, what ended it, and the shortest way to the next one.
#pragma once

#include "game/session/run_monitor.h"
#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"
#include "game/ui/session_best.h"

namespace gw {

struct GameOverFrame {
  double time_s = 0;     // since it is shown
  Best best{};           // of this session before this run
  bool canRetry = true;  // false: a replay's end
  Mode mode = Mode::arcade;
  uint32_t enemies = 0;  // that fit; swarm began with as many
  KeyHints keys{};
};

void drawGameOver(Canvas& canvas, const RunMonitor& run, const Rules& rules, const GameOverFrame& frame);

}  // namespace gw
