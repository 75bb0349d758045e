// The same replay with checksums that fit what it holds: a fuzzer does not guess hashes of 64 bits, and what lies
// behind them is to be read too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::fuzz {

// As far as there are whole chunks; the rest stays as it is.
std::vector<uint8_t> sealed(std::span<const uint8_t> bytes);

}  // namespace gw::fuzz
