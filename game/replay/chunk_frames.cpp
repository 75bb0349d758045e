#include "game/replay/chunk_frames.h"

#include <algorithm>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/deflate.h"

namespace gw {

using namespace replay_format;

std::string chunkName(uint32_t kind) {
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const char c = char(kind >> (8 * i));
    name += c >= 0x21 && c <= 0x7e ? c : '?';
  }
  return name;
}

ChunkFrames::ChunkFrames(std::span<const uint8_t> file, uint16_t major, const ReplayRefusal& refusal)
    : file_(file), major_(major), refusal_(refusal), offset_(kHeaderBytes) {}

// A power cut may leave a file at its length with zeros where nothing had reached the disk.
bool ChunkFrames::zerosFrom(size_t offset) const {
  const auto rest = file_.subspan(offset);
  return !rest.empty() && std::all_of(rest.begin(), rest.end(), [](uint8_t byte) { return byte == 0; });
}

std::optional<Chunk> ChunkFrames::next() {
  const size_t headerBytes = major_ == 1 ? kChunkHeaderBytes1 : kChunkHeaderBytes;
  if (left() < headerBytes || zerosFrom(offset_)) {
    ending_ = "it ends before its END! chunk";
    return std::nullopt;
  }
  const auto number = [&](size_t at) { return getLittle<uint32_t>(file_, offset_ + at); };
  Chunk chunk;
  chunk.kind = number(0);
  chunk.flags = number(4);
  chunk.offset = offset_;
  chunk.rawBytes = number(8);
  const size_t storedBytes = major_ == 1 ? chunk.rawBytes : number(12);
  chunk.firstTick = number(major_ == 1 ? 12 : 16);
  const std::string name = chunkName(chunk.kind);
  if (chunk.rawBytes > kMaxChunkBytes) {
    refusal_.damaged(fmt::format("chunk {} claims more than {} bytes", name, kMaxChunkBytes));
  }
  if (storedBytes > chunk.rawBytes) refusal_.damaged(fmt::format("chunk {} is longer stored than it is", name));
  if (chunk.flags & ~kRequired) refusal_.damaged(fmt::format("chunk {} has unknown flags", name));
  if (major_ != 1 && number(20) != 0) refusal_.damaged(fmt::format("chunk {} has a reserved number", name));
  if (storedBytes > left() - headerBytes) {
    ending_ = fmt::format("it ends within chunk {}", name);
    return std::nullopt;
  }
  chunk.stored = file_.subspan(offset_ + headerBytes, storedBytes);
  const size_t end = offset_ + headerBytes + storedBytes;
  if (getLittle<uint64_t>(file_, offset_ + headerBytes - 8) != replayChecksum(chunk.stored)) {
    if (storedBytes > 0 && zerosFrom(end - 1)) {
      ending_ = fmt::format("it ends in zeros within chunk {}", name);
      return std::nullopt;
    }
    refusal_.damaged(fmt::format("the checksum of chunk {} differs", name));
  }
  offset_ = end;
  return chunk;
}

std::span<const uint8_t> ChunkFrames::payload(const Chunk& chunk) {
  if (chunk.stored.size() == chunk.rawBytes) return chunk.stored;
  if (!inflateExactly(inflated_, chunk.rawBytes, chunk.stored)) {
    refusal_.damaged(fmt::format("chunk {} cannot be inflated to its length", chunkName(chunk.kind)));
  }
  return inflated_;
}

}  // namespace gw
