// The stand-in's device: memory is the host's own, with a page behind it that must not be touched.
#include <algorithm>
#include <cstring>

#include "cub/device/device_radix_sort.cuh"
#include "driver.h"

namespace gw::stand_in {

const char* const kOptionsVariable = "GW_CUDA_STAND_IN";
const char* const kOptionsHelp = "tests/fake_cuda/stand_in.h";
const char* const kDeviceName = "stand-in for CUDA (no GPU)";

int deviceArchitecture() {
  return 90;
}

bool takeDeviceOption(Options& options, const std::string& option) {
  if (option != "reversed") return false;
  options.reversed = true;
  return true;
}

void restartDevice() {}  // its memory is the driver's

void* allocateDevice(size_t bytes) {
  return allocateGuarded(bytes, false);
}
bool releaseDevice(void* pointer) {
  return releaseGuarded(pointer, false);
}
bool isDevice(const void* pointer, size_t bytes) {
  const Block* block = guardedBlock(pointer);
  return block && !block->pinned && guardedBlock(static_cast<const char*>(pointer) + bytes - 1) == block;
}
void pinnedAllocated(void*, size_t) {}  // threads of a block may use all memory
void pinnedReleased(void*) {}
void deviceWritten(void*, size_t) {}
void deviceForgotten(void* pointer, size_t bytes) {
  std::memset(pointer, kNeverWritten, bytes);
}

cudaError_t sortKeys(uint64_t* sorted, const uint64_t* keys, int count, int firstBit, int endBit, cudaStream_t stream) {
  GW_ENTER("cub::DeviceRadixSort::SortKeys");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  enqueue(*on, [=] {
    ++driver().kernels;
    const int bits = endBit - firstBit;
    const uint64_t mask = bits >= 64 ? ~0ull : (1ull << bits) - 1;
    std::copy(keys, keys + count, sorted);
    std::stable_sort(sorted, sorted + count,
                     [&](uint64_t a, uint64_t b) { return (a >> firstBit & mask) < (b >> firstBit & mask); });
  });
  return cudaSuccess;
}

}  // namespace gw::stand_in
