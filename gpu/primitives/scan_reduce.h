// Exclusive prefix sums and sums of 64-bit integers. Two 32-bit counts ride in one word (low and high
// half) as long as neither total passes 2^32 - 1.
//
// The scan stays in two levels: within blocks of kScanBlock, and over blocks. Readers add the two, which
// saves a launch: ScanView::before(i) is the sum of all words before i. What is summed need not stand in memory:
// run() takes whatever gives the word of an item, so that counting needs no launch of its own.
#pragma once

#include <gpuwars/buffer.h>
#include <gpuwars/detail/scan_block.h>

#include <type_traits>

namespace gw::GW_DEVICE {

// What kernels read. Copy it into a kernel by value.
struct ScanView {
  const uint64_t* within;        // [count] sum of the earlier items of the block
  const uint64_t* before_block;  // [blocks + 1] sum of the earlier blocks; the last one is the total
  uint32_t blocks;               // of kScanBlock items, the last one begun

  // The sum of all words before i, for i below count.
  GW_MEMBER uint64_t before(uint32_t i) const { return within[i] + before_block[i / kScanBlock]; }
  // The sum of all words.
  GW_MEMBER uint64_t total() const { return before_block[blocks]; }
};

// Its queue outlives it.
class Scan {
 public:
  Scan() = default;
  // Room for count words. Throws as Buffer does.
  Scan(Queue& queue, uint32_t count);

  // Of the last run(); valid while this lives.
  ScanView view() const;
  // As it was made for.
  uint32_t count() const { return count_; }

  // Of source(0) ... source(count - 1), each asked for once; leaves the result behind view(). Two launches, O(count).
  template <class Source>
  requires(!std::is_pointer_v<Source>) void run(Queue& queue, const Source& source) {
    forEachTeam(queue, scanBlocks(count_),
                ScanWithinBlocks<Source>{within_.data(), beforeBlock_.data(), source, count_});
    sumBlocks(queue);
  }
  // Of in[0] ... in[count - 1].
  void run(Queue& queue, const uint64_t* d_in);

 private:
  void sumBlocks(Queue& queue);

  uint32_t count_ = 0;
  Buffer<uint64_t> within_, beforeBlock_;
};

// *d_sum = in[0] + ... + in[count - 1] modulo 2^64. Two launches, O(count).
class Reduce {
 public:
  Reduce() = default;
  // Room for count words. Throws as Buffer does.
  Reduce(Queue& queue, uint32_t count);
  // d_in is [count]; both are device addresses.
  void run(Queue& queue, const uint64_t* d_in, uint64_t* d_sum);

 private:
  uint32_t count_ = 0;
  Buffer<uint64_t> sums_;
};

}  // namespace gw::GW_DEVICE
