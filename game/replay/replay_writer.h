// Writes a replay: all of it or nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "game/replay/replay.h"

namespace gw {

// The bytes of the file. Equal replays give equal bytes with the same zlib. Throws std::invalid_argument on a replay
// that no reader would take as whole (no tick, no end, inputs and hashes of different counts, a number out of its
// range).
std::vector<uint8_t> encodeReplay(const Replay& replay);

// Throws FileError when it cannot be written; a file that stood at `path` is then untouched.
void writeReplay(const std::filesystem::path& path, const Replay& replay);

}  // namespace gw
