// The replay that is to be shown, and the ticks of it that the command line names.
#pragma once

#include "game/cli/command_line.h"
#include "game/replay/replay.h"

namespace gw {

// What is whole of it; says on stderr when that is not all. Throws ReplayError.
Replay readWatched(const Options& options);

// The tick, when the replay has it. Throws UserError when it ends before.
uint32_t tickInside(const Options& options, const char* option, uint32_t tick, const Replay& replay);

}  // namespace gw
