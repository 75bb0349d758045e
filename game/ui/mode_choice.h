// The four modes by name and in a line each, and the choice between them on the title.
#pragma once

#include <string_view>

#include "game/sim/simulation.h"
#include "game/ui/canvas.h"

namespace gw {

inline constexpr uint32_t kModeCount = 4;

std::string_view modeName(Mode mode);  // "arcade", as the command line has it
std::string_view modeLine(Mode mode);  // what it is, for the title

// `steps` to the right, round and round.
Mode modeBeside(Mode mode, int steps);

// All of them in a row, the chosen one marked, and its line under them; 40 units high below `baseline`.
void drawModeChoice(Canvas& canvas, Mode chosen, float baseline);

}  // namespace gw
