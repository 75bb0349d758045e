// The title: the name in neon over a game that plays itself. Any start key starts at once.
#pragma once

#include <string>

#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"

namespace gw {

struct TitleFrame {
  double time_s = 0;     // since it is shown
  std::string device;    // what simulates, e.g. "cpu, 2 threads"
  uint32_t enemies = 0;  // that fit
  std::string mode;      // "arcade"
  uint64_t best = 0;     // of this session
  KeyHints keys{};
};

void drawTitle(Canvas& canvas, const TitleFrame& frame);

}  // namespace gw
