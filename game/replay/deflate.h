// Compressed chunks: zlib streams that give exactly the bytes they were made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw {

// Empty when that is not smaller.
std::vector<uint8_t> deflated(std::span<const uint8_t> raw);

// Fills `raw` with `rawBytes` bytes; false when the stream gives another number or is no stream, or when something
// follows it. Never writes more, whatever the stream says.
bool inflateExactly(std::vector<uint8_t>& raw, size_t rawBytes, std::span<const uint8_t> stream);

}  // namespace gw
