// A file is written whole or not at all: a temporary file beside it, synced, then renamed over it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace gw {

// Both throw ReplayError with one sentence.

// Checks that a file could be written at `path` by making the temporary file and removing it again.
void checkWritable(const std::filesystem::path& path);

// What stood at `path` survives a failure, and nothing else is left behind.
void writeFileAtomically(const std::filesystem::path& path, std::span<const uint8_t> bytes);

}  // namespace gw
