// The chunks of a replay file, one after the other: where each begins and ends, that it is as it was written, and what
// it holds when inflated. Knows the framing of majors 1 and 2, and no kind of chunk.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/replay/replay_refusal.h"

namespace gw {

// A chunk's name as text; what is no letter shows as '?'.
std::string chunkName(uint32_t kind);

struct Chunk {
  uint32_t kind = 0, flags = 0, firstTick = 0;
  size_t offset = 0;    // of its header, in the file
  size_t rawBytes = 0;  // of its payload
  std::span<const uint8_t> stored;
};

class ChunkFrames {
 public:
  // `file` begins with its header, and like `refusal` outlives this.
  ChunkFrames(std::span<const uint8_t> file, uint16_t major, const ReplayRefusal& refusal);

  // The next chunk, its checksum compared; none where the file ends before that chunk does. Throws ReplayError.
  std::optional<Chunk> next();

  // What the chunk holds, until the next call. Inflates what is compressed: so ask for chunks that are known, once
  // their place is found right.
  std::span<const uint8_t> payload(const Chunk& chunk);

  // After next() gave none: how the file ends, as part of a sentence.
  const std::string& ending() const { return ending_; }
  size_t left() const { return file_.size() - offset_; }  // bytes behind the last chunk

 private:
  bool zerosFrom(size_t offset) const;

  std::span<const uint8_t> file_;
  uint16_t major_;
  const ReplayRefusal& refusal_;
  size_t offset_;
  std::string ending_;
  std::vector<uint8_t> inflated_;
};

}  // namespace gw
