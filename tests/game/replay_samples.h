// Replays for tests: small ones, and forged ones whose checksums are right although the content is not.
#pragma once

#include <cstdint>
#include <vector>

#include "game/replay/replay.h"

namespace gw::test {

using Bytes = std::vector<uint8_t>;

// Twelve ticks in five runs, short stand-ins for the tables.
Replay sampleReplay();

// What the message says about `bytes`; "" when they are accepted.
std::string refusalOf(const Bytes& bytes);

struct ForgedChunk {
  uint32_t kind, flags, firstTick;
  Bytes payload;
  uint32_t claimedLength;  // what its header says
};

// A file taken apart, to be changed and sealed again.
struct ForgedFile {
  Bytes header;
  std::vector<ForgedChunk> chunks;  // without END!, which seal() makes

  explicit ForgedFile(const Bytes& file);
  ForgedChunk& chunk(uint32_t kind);
  void setHeader16(size_t offset, uint16_t value);
  void setHeader32(size_t offset, uint32_t value);
  // With every checksum made to fit; the chunk count too unless told otherwise.
  Bytes seal(bool countChunks = true) const;
};

}  // namespace gw::test
