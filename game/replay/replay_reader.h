// Reads a replay, trusting nothing: every length is compared with what is left and with the limits of format.h before
// anything is allocated, and a file that differs in a single byte from what was written is refused.
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

enum class Completeness {
  whole,    // a file that was cut, or whose writer died, is refused with the remedy
  partial,  // what is whole of it is read: Replay::whole says whether that is all. For watching or mending
};

// Throws ReplayError. The most it allocates at a time, whatever the file says: the file's own size, and 32 MiB.
Replay readReplay(const std::filesystem::path& path, SimulationVersions versions = SimulationVersions::current,
                  Completeness completeness = Completeness::whole);

// The same for bytes in memory; `name` is what messages call them.
Replay decodeReplay(std::span<const uint8_t> bytes, const std::string& name,
                    SimulationVersions versions = SimulationVersions::current,
                    Completeness completeness = Completeness::whole);

}  // namespace gw
