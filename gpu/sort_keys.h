// Ascending sort of 64-bit keys that are all different, so that the result is uniquely defined and each
// device may use what suits it: CUB's radix sort on cuda (the only file that includes CUB), std::sort on
// cpu.
#pragma once

#include "gpu/buffer.h"

namespace gw::GW_DEVICE {

class SortKeys {
 public:
  SortKeys() = default;
  SortKeys(Queue& queue, uint32_t count);

  uint64_t* keys() const { return keys_.data(); }  // [count] filled by the caller, sorted by run()
  void run(Queue& queue);

 private:
  uint32_t count_ = 0;
  Buffer<uint64_t> keys_, sorted_;
  Buffer<unsigned char> scratch_;
};

}  // namespace gw::GW_DEVICE
