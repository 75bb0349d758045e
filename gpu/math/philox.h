// Philox4x32-10, the counter-based generator of Salmon, Moraes, Dror, Shaw: "Parallel random numbers: as
// easy as 1, 2, 3" (SC'11). A number is a pure function of key and counter, so no draw depends on how many
// others were made or by which thread. Key: the seed. Counter: (tick, entity id, purpose, n).
#pragma once

#include <gpuwars/device.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// Four independent numbers of 32 bits for each key and counter. Never fails.
GW_FN Uint4 philox(uint64_t key, Uint4 counter) {
  uint32_t k0 = uint32_t(key), k1 = uint32_t(key >> 32);
  for (int round = 0; round < 10; ++round) {
    const uint64_t a = uint64_t(0xD2511F53u) * counter.x, b = uint64_t(0xCD9E8D57u) * counter.z;
    counter = {uint32_t(b >> 32) ^ counter.y ^ k0, uint32_t(b), uint32_t(a >> 32) ^ counter.w ^ k1, uint32_t(a)};
    k0 += 0x9E3779B9u;
    k1 += 0xBB67AE85u;
  }
  return counter;
}

// 24 bits to [0, 1): every value is exact.
GW_FN float unitFloat(uint32_t bits) {
  return float(bits >> 8) * 5.9604644775390625e-8f;
}

}  // namespace gw::GW_DEVICE
