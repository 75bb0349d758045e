// Stable ascending sort of 64-bit keys by some of their bits. The result is uniquely defined, so each device may use
// what suits it: CUB's radix sort on cuda (the only file that includes CUB), one of digits of 11 bits on cpu.
#pragma once

#include <gpuwars/buffer.h>
#if !GW_ON_CUDA
#include <gpuwars/bin_sort.h>  // whose cuda side in turn uses this
#endif

namespace gw::GW_DEVICE {

// The keys and the memory that sorting takes. Its queue outlives it.
class SortKeys {
 public:
  SortKeys() = default;
  // Room for count keys. Throws as Buffer does.
  SortKeys(Queue& queue, uint32_t count);

  // [count] filled by the caller, sorted by run(), which may leave them in another buffer: ask again after it. Code
  // that captures a run fills and reads in the same capture.
  uint64_t* keys() const { return keys_.data(); }
  // Compares bits firstBit .. endBit - 1, 0 <= firstBit < endBit <= 64; keys equal in these keep their order. O(count)
  // per digit.
  void run(Queue& queue, uint32_t firstBit = 0, uint32_t endBit = 64);
  size_t bytes() const;  // of device memory held

 private:
  uint32_t count_ = 0;
  Buffer<uint64_t> keys_, sorted_;
#if GW_ON_CUDA
  Buffer<unsigned char> scratch_;
#else
  BinSort digits_;
#endif
};

}  // namespace gw::GW_DEVICE
