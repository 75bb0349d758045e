// What a person does in a window, from its opening to its end.
#pragma once

#include "game/cli/play_options.h"
#include "game/cli/replay_options.h"

namespace gw {

ExitCode playWindow(const PlayOptions& options);
ExitCode watchReplay(const ReplayOptions& options);

}  // namespace gw
