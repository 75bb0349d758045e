// Which operands an input's number stands for, and the hash of results.
#pragma once

#include "gpu/math/bits.h"
#include "gpu/math/philox.h"
#include "gpu/math/state_hash.h"
#include "tests/gpu/arithmetic/blocks.h"

namespace gw::GW_DEVICE {

// Raw bit patterns. Two exponents drawn apart rarely meet, and then a sum is just its larger part: every other pair has
// exponents within 16 of each other. One in 16 has an operand of the kind that rounding treats apart.
GW_FN Float2 pairOf(uint64_t input) {
  const Uint4 random = philox(0xA417E71Cull, {uint32_t(input), uint32_t(input >> 32), 0, 0});
  uint32_t a = random.x, b = random.y;
  if (random.z & 1u) {
    const uint32_t exponent = ((a >> 23) + (random.z >> 1 & 31u) + 240u) & 255u;  // 16 less to 15 more, in a circle
    b = (b & 0x807FFFFFu) | exponent << 23;
  }
  constexpr uint32_t kSpecial[] = {0x00000000u, 0x80000000u, 0x00000001u, 0x807FFFFFu, 0x00800000u, 0x7F7FFFFFu,
                                   0x7F800000u, 0xFF800000u, 0x7FC00000u, 0x3F800000u, 0xBF800000u, 0x3F800001u,
                                   0x3F7FFFFFu, 0x34000000u, 0x00400000u, 0x7F000000u};
  if ((random.w & 31u) == 0) a = kSpecial[random.w >> 5 & 15u];
  if ((random.w & 31u) == 1) b = kSpecial[random.w >> 5 & 15u];
  return {floatOf(a), floatOf(b)};
}

// An odd factor visits every pattern once: the first few are then a sample of all, and 2^32 are all.
GW_FN float rootOf(uint64_t input) {
  return floatOf(uint32_t(input) * 0x9E3779B1u);
}

GW_FN uint32_t canonicalBits(float value) {
  return value != value ? 0x7FC00000u : bitsOf(value);
}

GW_FN uint64_t withResult(uint64_t hash, uint32_t bits) {
  return mixed(hash + bits + 1);
}

GW_FN uint64_t withResults(uint64_t hash, const test::Computed& computed) {
  for (uint32_t k = 0; k < test::kResults; ++k) hash = withResult(hash, computed.results[k]);
  return hash;
}

}  // namespace gw::GW_DEVICE
