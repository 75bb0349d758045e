#include "tests/fuzz/sealed_replay.h"

#include <algorithm>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/format.h"

namespace gw::fuzz {

using namespace replay_format;

std::vector<uint8_t> sealed(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> file(bytes.begin(), bytes.end());
  if (file.size() < kHeaderBytes) return file;
  const std::span<const uint8_t> all(file);
  putLittleAt(file, kOffsetChecksum, replayChecksum(all.first(kOffsetChecksum)));
  const bool first = getLittle<uint16_t>(all, kOffsetMajor) == 1;
  const size_t headerBytes = first ? kChunkHeaderBytes1 : kChunkHeaderBytes;
  for (size_t at = kHeaderBytes; file.size() - at >= headerBytes;) {
    const size_t left = file.size() - at - headerBytes, length = getLittle<uint32_t>(all, at + (first ? 8 : 12));
    if (length > left) break;
    const size_t payload = at + headerBytes;
    if (getLittle<uint32_t>(all, at) == kEndChunk && length == kEndBytes) {
      putLittleAt(file, payload, replayChecksum(all.first(at)));
    }
    putLittleAt(file, payload - 8, replayChecksum(all.subspan(payload, length)));
    at = payload + length;
  }
  return file;
}

}  // namespace gw::fuzz
