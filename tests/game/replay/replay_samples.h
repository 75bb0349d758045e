// Replays for tests: small ones, and forged ones whose checksums are right although the content is not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "game/replay/replay.h"

namespace gw::test {

using Bytes = std::vector<uint8_t>;

// Twelve ticks in five runs, short stand-ins for the tables.
Replay sampleReplay();

// The same for 150 ticks: long enough for hashes by field, and some of its chunks are compressed.
Replay longerReplay();

// As a program of format 1.1 wrote it, and as a recorder leaves it that is killed after its last full second.
Bytes format1(const Replay& replay);
Bytes growingFile(const Replay& replay);

// A tick as the recorder takes it.
TickReport reportOf(const Replay& replay, size_t index);

// Everything but whether it is whole.
bool sameContent(const Replay& a, const Replay& b);

// What the message says about `bytes`; "" when they are accepted.
std::string refusalOf(const Bytes& bytes);

struct ForgedChunk {
  uint32_t kind, flags, firstTick;
  Bytes payload;                               // inflated
  uint32_t claimedLength;                      // what its header says of that
  std::optional<Bytes> stored = {};            // none: the payload as it is
  std::optional<uint32_t> claimedStored = {};  // none: as long as it is, or claims to be where it is not compressed
};

// A file taken apart, to be changed and sealed again.
struct ForgedFile {
  Bytes header;
  std::vector<ForgedChunk> chunks;  // without END!, which seal() makes

  explicit ForgedFile(const Bytes& file);
  // The first of its kind, not compressed any more.
  ForgedChunk& chunk(uint32_t kind);
  void setHeader16(size_t offset, uint16_t value);
  void setHeader32(size_t offset, uint32_t value);
  // Where each chunk ends in the sealed file.
  std::vector<size_t> ends() const;
  // With every checksum made to fit; the chunk count too unless told otherwise.
  Bytes seal(bool countChunks = true) const;

 private:
  void putForged(Bytes& file, const ForgedChunk& chunk) const;
};

}  // namespace gw::test
