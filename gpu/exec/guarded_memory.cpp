#include <gpuwars/guarded_memory.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace gw {

void* GuardedMemory::allocate(size_t bytes) {
  const size_t page = size_t(sysconf(_SC_PAGESIZE));
  // What cannot be rounded up is asked for as it is, and refused.
  const size_t rounded = bytes > SIZE_MAX - page ? bytes : std::max(page, (bytes + page - 1) / page * page);
  const int protection = protect_ && depth_ == 0 ? PROT_NONE : PROT_READ | PROT_WRITE;
  void* start = mmap(nullptr, rounded, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (start == MAP_FAILED) {
    throw std::runtime_error("The cpu device could not get " + std::to_string(rounded >> 20) +
                             " MiB of memory; use fewer --enemies.");
  }
  ranges_.push_back({start, rounded});
  return start;
}

void GuardedMemory::release(void* pointer) {
  const auto range = std::find_if(ranges_.begin(), ranges_.end(), [&](const Range& r) { return r.start == pointer; });
  if (range == ranges_.end()) return;
  munmap(range->start, range->bytes);
  ranges_.erase(range);
}

GuardedMemory::~GuardedMemory() {
  for (const Range& range : ranges_) munmap(range.start, range.bytes);
}

void GuardedMemory::open() {
  if (depth_++ == 0 && protect_) setProtection(PROT_READ | PROT_WRITE);
}

void GuardedMemory::close() {
  if (--depth_ == 0 && protect_) setProtection(PROT_NONE);
}

void GuardedMemory::setProtection(int protection) {
  for (const Range& range : ranges_) {
    if (mprotect(range.start, range.bytes, protection) != 0) {
      throw std::runtime_error("The cpu device could not protect its memory; run without --protect-memory.");
    }
  }
}

}  // namespace gw
