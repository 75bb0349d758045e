// Exclusive prefix sums and sums of 64-bit integers. Two 32-bit counts ride in one word (low and high
// half) as long as neither total passes 2^32 - 1.
//
// The scan stays in two levels: within blocks of kScanBlock, and over blocks. Readers add the two, which
// saves a launch: ScanView::before(i) is the sum of all in[j], j < i.
#pragma once

#include "gpu/buffer.h"

namespace gw::GW_DEVICE {

inline constexpr uint32_t kScanBlock = 1024;

GW_FN uint32_t scanBlocks(uint32_t count) {
  return (count + kScanBlock - 1) / kScanBlock;
}

struct ScanView {
  const uint64_t* within;        // [count] sum of the earlier items of the block
  const uint64_t* before_block;  // [blocks + 1] sum of the earlier blocks; the last one is the total
  uint32_t blocks;

  GW_MEMBER uint64_t before(uint32_t i) const { return within[i] + before_block[i / kScanBlock]; }
  GW_MEMBER uint64_t total() const { return before_block[blocks]; }
};

class Scan {
 public:
  Scan() = default;
  Scan(Queue& queue, uint32_t count);

  ScanView view() const;
  uint32_t count() const { return count_; }

  // Reads in[0 .. count), leaves the result behind view(). Two launches, O(count).
  void run(Queue& queue, const uint64_t* d_in);

 private:
  uint32_t count_ = 0;
  Buffer<uint64_t> within_, beforeBlock_;
};

// *d_sum = in[0] + ... + in[count - 1] modulo 2^64. Two launches, O(count).
class Reduce {
 public:
  Reduce() = default;
  Reduce(Queue& queue, uint32_t count);
  void run(Queue& queue, const uint64_t* d_in, uint64_t* d_sum);

 private:
  uint32_t count_ = 0;
  Buffer<uint64_t> sums_;
};

}  // namespace gw::GW_DEVICE
