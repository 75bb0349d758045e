// The replay to watch or draw, and the ticks of it that the command line names.
#pragma once

#include <filesystem>

#include "game/replay/replay.h"

namespace gw {

// What is whole of it; says on stderr when that is not all. Throws ReplayError.
Replay readWatched(const std::filesystem::path& file);

// The tick that `option` names, when the replay of `file` has it. Throws UserError when it ends before.
uint32_t tickInside(const std::filesystem::path& file, const char* option, uint32_t tick, const Replay& replay);

}  // namespace gw
