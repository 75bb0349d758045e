#include "game/replay/deflate.h"

#include <zlib.h>

namespace gw {

std::vector<uint8_t> deflated(std::span<const uint8_t> raw) {
  std::vector<uint8_t> stream(compressBound(uLong(raw.size())));
  uLongf length = uLongf(stream.size());
  const bool done = compress2(stream.data(), &length, raw.data(), uLong(raw.size()), Z_BEST_COMPRESSION) == Z_OK;
  stream.resize(done && length < raw.size() ? length : 0);
  return stream;
}

bool inflateExactly(std::vector<uint8_t>& raw, size_t rawBytes, std::span<const uint8_t> stream) {
  raw.resize(rawBytes);
  uLongf length = uLongf(rawBytes);
  uLong read = uLong(stream.size());
  return uncompress2(raw.data(), &length, stream.data(), &read) == Z_OK && length == rawBytes && read == stream.size();
}

}  // namespace gw
