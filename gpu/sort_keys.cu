#include "gpu/sort_keys.h"

#if GW_ON_CUDA
#include <cub/device/device_radix_sort.cuh>
#else
#include <algorithm>
#endif

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

SortKeys::SortKeys(Queue& queue, uint32_t count) : count_(count), keys_(queue, count), sorted_(queue, count) {
  size_t bytes = 0;
  check(cub::DeviceRadixSort::SortKeys(nullptr, bytes, keys_.data(), sorted_.data(), int(count), 0, 64, queue.stream),
        "sizing the radix sort");
  scratch_ = Buffer<unsigned char>(queue, bytes);
}

void SortKeys::run(Queue& queue) {
  size_t bytes = scratch_.size();
  check(cub::DeviceRadixSort::SortKeys(scratch_.data(), bytes, keys_.data(), sorted_.data(), int(count_), 0, 64,
                                       queue.stream),
        "the radix sort");
  copyBytes(queue, keys_.data(), sorted_.data(), count_ * sizeof(uint64_t), Copy::onDevice);
}

#else

SortKeys::SortKeys(Queue& queue, uint32_t count) : count_(count), keys_(queue, count) {}

void SortKeys::run(Queue& queue) {
  GuardedMemory::Access access(queue.memory);
  std::sort(keys_.data(), keys_.data() + count_);
}

#endif

}  // namespace gw::GW_DEVICE
