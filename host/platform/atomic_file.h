// A file is written whole or not at all: a temporary file beside it, synced, then renamed over it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "host/platform/user_error.h"

namespace gw {

// One sentence: the file, what is wrong with it, and what to do about it.
struct FileError : UserError {
  explicit FileError(const std::string& sentence) : UserError(ExitCode::badFile, sentence) {}
};

// Both throw FileError.

// Checks that a file could be written at `path` by making the temporary file and removing it again.
void checkWritable(const std::filesystem::path& path);

// When the disk itself has what was written. Later: a power cut may lose it.
enum class Sync { now, later };

// What stood at `path` survives a failure, and nothing else is left behind. Its permissions stay as they are.
void writeFileAtomically(const std::filesystem::path& path, std::span<const uint8_t> bytes, Sync sync = Sync::now);

}  // namespace gw
