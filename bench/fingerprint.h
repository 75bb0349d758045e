// What a bench computed, in 64 bits: two builds whose fingerprints are equal did the same work (FNV-1a over the
// bytes in the order in which they are added).
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace gw::bench {

class Fingerprint {
 public:
  void add(uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) {
      value_ = (value_ ^ ((word >> shift) & 0xff)) * 0x00000100000001b3ull;
    }
  }
  template <class Integer>
  void add(const std::vector<Integer>& words) {
    for (const Integer word : words) add(uint64_t(word));
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xcbf29ce484222325ull;
};

// The line that --hash prints: "hash WHAT: 16 digits".
inline std::string hashLine(const std::string& what, uint64_t hash) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return "hash " + what + ": " + digits + "\n";
}

}  // namespace gw::bench
