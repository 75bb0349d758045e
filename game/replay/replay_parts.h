// The parts of a replay file as bytes, which a whole file and one that grows have in common. Each is put at the end
// of `bytes`; where those have room reserved, the parts of ticks allocate nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/replay/replay.h"

namespace gw {

// The header, with its checksum. No ticks and no chunks: of a file that grows.
void putReplayHeader(std::vector<uint8_t>& bytes, const ReplayHeader& header, uint32_t ticks, uint32_t chunks);

// A chunk whose payload is stored as it is, or compressed where that is smaller.
void putPlainChunk(std::vector<uint8_t>& bytes, uint32_t kind, uint32_t flags, uint32_t firstTick,
                   std::span<const uint8_t> payload);
void putChunk(std::vector<uint8_t>& bytes, uint32_t kind, uint32_t flags, uint32_t firstTick,
              std::span<const uint8_t> payload);

// Payloads.
void putTables(std::vector<uint8_t>& bytes, const RuleTexts& rules);
void putInputs(std::vector<uint8_t>& bytes, std::span<const InputRecord> inputs);
void putHashes(std::vector<uint8_t>& bytes, std::span<const uint64_t> hashes);
void putFieldHashes(std::vector<uint8_t>& bytes, std::span<const FieldHashes> fieldHashes);
void putFinal(std::vector<uint8_t>& bytes, const FinalReport& result);

}  // namespace gw
