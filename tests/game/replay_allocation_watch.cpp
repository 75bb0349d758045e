#include "tests/game/replay_allocation_watch.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<size_t> largest{0};
}

namespace gw::test {
void watchAllocations() {
  largest = 0;
}
size_t largestAllocation() {
  return largest;
}
}  // namespace gw::test

// The array forms call these; sizes alone matter here.
void* operator new(size_t size) {
  for (size_t seen = largest; size > seen && !largest.compare_exchange_weak(seen, size);) {
  }
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}
