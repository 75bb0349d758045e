// Words of state to a 64-bit hash that does not depend on the order of visits: each word is mixed with the
// key of its place (who, which field) and the results are added.
#pragma once

#include <gpuwars/device.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every input bit reaches every output bit.
GW_FN uint64_t mixed(uint64_t word) {
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9ull;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBull;
  return word ^ (word >> 31);
}

// The hashes of the 64-bit words that stand at (owner, 0), (owner, 1), ... in turn. Places lie a constant apart, so
// that the next one is an addition. Owners and fields up to 2^32 - 1.
class WordHashes {
 public:
  // Begins at the word (owner, field).
  GW_FN explicit WordHashes(uint32_t owner, uint32_t field = 0)
      : place_((uint64_t(owner) << 32 | field) * kApart + 0xD1B54A32D192ED03ull) {}

  // The hash of the next word.
  GW_FN uint64_t next(uint64_t word) {
    const uint64_t hash = mixed((word + place_) ^ (place_ >> 29));
    place_ += kApart;
    return hash;
  }

 private:
  static constexpr uint64_t kApart = 0x9E3779B97F4A7C15ull;
  uint64_t place_;
};

// The hash of one of them.
GW_FN uint64_t hashWord(uint32_t owner, uint32_t field, uint64_t word) {
  return WordHashes(owner, field).next(word);
}

}  // namespace gw::GW_DEVICE
