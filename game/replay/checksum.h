// The checksum of replay chunks and files: XXH3, 64 bits, seed 0.
#pragma once

#include <cstdint>
#include <span>

namespace gw {

uint64_t replayChecksum(std::span<const uint8_t> bytes);

}  // namespace gw
