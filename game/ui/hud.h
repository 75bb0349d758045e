// What is shown while playing: the BUDGET meter (deadline: the clock) with the real frame rate beside it, score,
// multiplier, data per second, flushes, wave, enemies, and what hit the ship.
#pragma once

#include <string>

#include "game/session/run_monitor.h"
#include "game/ui/canvas.h"

namespace gw {

struct HudFrame {
  double realFps = 0;
  uint64_t droppedTicks = 0;  // time lost because ticks took too long
  std::string banner;         // e.g. "REPLAY x2"; empty: none
  std::string best;           // of earlier runs in this mode; empty: none
  Mode mode = Mode::arcade;
  uint32_t enemies = 0;  // that fit; swarm begins with as many
};

// The share of the meter that is left: 1 at 60 FPS, 0 at 12, linear in frame time.
float budgetLeft(uint32_t frameTime_us, const Rules::Budget& budget);

// What a contact costs in deadline, in ticks of the clock.
uint32_t clockCost_ticks(uint32_t contact_us, const Rules::Deadline& deadline);

void drawHud(Canvas& canvas, const RunMonitor& run, const Rules& rules, const HudFrame& frame);

}  // namespace gw
