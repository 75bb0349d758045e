// Reads a replay, trusting nothing: every length is compared with what is left before anything is
// allocated, and a file that differs in a single byte from what was written is refused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "game/replay/replay.h"

namespace gw {

enum class SimulationVersions {
  current,  // others are refused by name, with the remedy
  any,      // for tools that bring old replays up to date
};

// Throws ReplayError.
Replay readReplay(const std::filesystem::path& path, SimulationVersions versions = SimulationVersions::current);

// The same for bytes in memory; `name` is what messages call them.
Replay decodeReplay(std::span<const uint8_t> bytes, const std::string& name,
                    SimulationVersions versions = SimulationVersions::current);

}  // namespace gw
