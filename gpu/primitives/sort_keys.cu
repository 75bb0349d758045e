#include <gpuwars/sort_keys.h>

#include <utility>

#if GW_ON_CUDA
#include <cub/device/device_radix_sort.cuh>
#endif

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

// Of CCCL 3.0.1 (CUDA 13.0), dispatch_radix_sort.cuh and tuning_radix_sort.cuh: keys of 64 bits are sorted by one block
// when they fit its tile, else by "onesweep" on every architecture from 6.0 on (ONESWEEP is set for keys of at least 32
// bits), by digits of 8 bits: one launch for the histograms of all digits, one for their sums, one for each digit.
// Beyond 2^28 keys it goes by portions. With a DoubleBuffer the digits go to and fro between the two buffers given
// here; without, it would take a third one, and the caller a copy.
SortKeys::SortKeys(Queue& queue, uint32_t count) : count_(count), keys_(queue, count), sorted_(queue, count) {
  cub::DoubleBuffer<uint64_t> keys(keys_.data(), sorted_.data());
  size_t bytes = 0;  // the most: by all bits
  check(cub::DeviceRadixSort::SortKeys(nullptr, bytes, keys, int(count), 0, 64, queue.stream),
        "preparing to sort keys");
  scratch_ = Buffer<unsigned char>(queue, bytes);
}

void SortKeys::run(Queue& queue, uint32_t firstBit, uint32_t endBit) {
  cub::DoubleBuffer<uint64_t> keys(keys_.data(), sorted_.data());
  size_t bytes = scratch_.size();
  check(cub::DeviceRadixSort::SortKeys(scratch_.data(), bytes, keys, int(count_), int(firstBit), int(endBit),
                                       queue.stream),
        "sorting keys");
  ++queue.launches;  // at least: how many there are is CUB's own affair
  ++queue.pending;
  if (keys.Current() != keys_.data()) std::swap(keys_, sorted_);
}

size_t SortKeys::bytes() const {
  return 2 * count_ * sizeof(uint64_t) + scratch_.size();
}

#else

namespace {

constexpr uint32_t kDigitBits = 11;

struct DigitOfKey {
  const uint64_t* keys;
  uint32_t shift, mask;
  uint32_t operator()(uint32_t i) const { return uint32_t(keys[i] >> shift) & mask; }
};

struct MoveKey {
  uint64_t* sorted;
  const uint64_t* keys;
  void operator()(uint32_t from, uint32_t to) const { sorted[to] = keys[from]; }
};

}  // namespace

SortKeys::SortKeys(Queue& queue, uint32_t count)
    : count_(count), keys_(queue, count), sorted_(queue, count), digits_(queue, count, 1u << kDigitBits) {}

void SortKeys::run(Queue& queue, uint32_t firstBit, uint32_t endBit) {
  for (uint32_t bit = firstBit; bit < endBit; bit += kDigitBits) {
    const uint32_t bits = smaller(kDigitBits, endBit - bit);
    digits_.run(queue, DigitOfKey{keys_.data(), bit, (1u << bits) - 1}, MoveKey{sorted_.data(), keys_.data()});
    std::swap(keys_, sorted_);
  }
}

size_t SortKeys::bytes() const {
  return 2 * count_ * sizeof(uint64_t) + digits_.bytes();
}

#endif

}  // namespace gw::GW_DEVICE
