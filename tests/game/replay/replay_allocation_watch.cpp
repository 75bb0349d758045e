#include "tests/game/replay/replay_allocation_watch.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<size_t> largest{0}, count{0};
std::atomic<ptrdiff_t> held{0}, peak{0};

template <typename T>
void raise(std::atomic<T>& most, T value) {
  for (T seen = most; value > seen && !most.compare_exchange_weak(seen, value);) {
  }
}
}  // namespace

namespace gw::test {
void watchAllocations() {
  largest = count = 0;
  held = peak = 0;
}
size_t largestAllocation() {
  return largest;
}
size_t peakAllocated() {
  return size_t(peak.load());
}
size_t allocations() {
  return count;
}
}  // namespace gw::test

// The array forms call these.
void* operator new(size_t size) {
  raise(largest, size);
  ++count;
  void* memory = std::malloc(size ? size : 1);
  if (!memory) throw std::bad_alloc();
  raise(peak, held += ptrdiff_t(malloc_usable_size(memory)));
  return memory;
}
void operator delete(void* memory) noexcept {
  held -= ptrdiff_t(malloc_usable_size(memory));
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  operator delete(memory);
}
