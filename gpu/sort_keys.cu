#include "gpu/sort_keys.h"

#if GW_ON_CUDA
#include <cub/device/device_radix_sort.cuh>
#endif

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

SortKeys::SortKeys(Queue& queue, uint32_t count) : count_(count), keys_(queue, count), sorted_(queue, count) {
  size_t bytes = 0;
  check(cub::DeviceRadixSort::SortKeys(nullptr, bytes, keys_.data(), sorted_.data(), int(count), 0, 64, queue.stream),
        "preparing to sort keys");
  scratch_ = Buffer<unsigned char>(queue, bytes);
}

void SortKeys::run(Queue& queue, uint32_t firstBit, uint32_t endBit) {
  size_t bytes = scratch_.size();
  check(cub::DeviceRadixSort::SortKeys(scratch_.data(), bytes, keys_.data(), sorted_.data(), int(count_), int(firstBit),
                                       int(endBit), queue.stream),
        "sorting keys");
  ++queue.pending;  // at least: how many there are is CUB's own affair
  copyBytes(queue, keys_.data(), sorted_.data(), count_ * sizeof(uint64_t), Copy::onDevice);
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
  uint64_t *from = keys_.data(), *to = sorted_.data();
  for (uint32_t bit = firstBit; bit < endBit; bit += kDigitBits) {
    const uint32_t bits = smaller(kDigitBits, endBit - bit);
    digits_.run(queue, DigitOfKey{from, bit, (1u << bits) - 1}, MoveKey{to, from});
    std::swap(from, to);
  }
  if (from != keys_.data()) copyBytes(queue, keys_.data(), from, count_ * sizeof(uint64_t), Copy::onDevice);
}

size_t SortKeys::bytes() const {
  return 2 * count_ * sizeof(uint64_t) + digits_.bytes();
}

#endif

}  // namespace gw::GW_DEVICE
