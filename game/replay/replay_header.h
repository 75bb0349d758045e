// The first 128 bytes of a replay file: what kind of file it is, and what is known of the run before its first tick.
#pragma once

#include <cstdint>
#include <span>

#include "game/replay/replay_reader.h"
#include "game/replay/replay_refusal.h"

namespace gw {

struct ReplayFileHeader {
  ReplayHeader run;
  uint16_t major = kReplayMajor;
  uint32_t ticks = 0, chunks = 0;  // both 0: the file is growing, or its writer died
  bool growing() const { return ticks == 0 && chunks == 0; }
};

// Throws ReplayError for a file of more bytes than any replay has.
void refuseTooLarge(uint64_t bytes, const ReplayRefusal& refusal);

// Tells empty, foreign and shortened files apart, since each has another remedy, and checks every number. Throws
// ReplayError.
ReplayFileHeader readReplayHeader(std::span<const uint8_t> file, const ReplayRefusal& refusal,
                                  SimulationVersions versions);

}  // namespace gw
