#include "game/replay/checksum.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gw {

uint64_t replayChecksum(std::span<const uint8_t> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace gw
