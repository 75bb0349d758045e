// Memory of the cpu device. It belongs to the kernels: with protection on, host code that reads or writes
// it outside a launch or a declared copy dies with SIGSEGV, just as it would on a real GPU.
#pragma once

#include <cstddef>
#include <vector>

namespace gw {

class GuardedMemory {
 public:
  explicit GuardedMemory(bool protect) : protect_(protect) {}
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  // Zeroed, page-aligned. Throws std::runtime_error with a sentence when the machine has no more.
  void* allocate(size_t bytes);
  void release(void* pointer);

  // Whole pages each, in the order in which they were allocated.
  struct Range {
    void* start;
    size_t bytes;
  };
  const std::vector<Range>& ranges() const { return ranges_; }

  // Opens all of it for as long as the object lives; nests.
  class Access {
   public:
    explicit Access(GuardedMemory& memory) : memory_(memory) { memory_.open(); }
    ~Access() { memory_.close(); }
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;

   private:
    GuardedMemory& memory_;
  };

 private:
  void open();
  void close();
  void setProtection(int protection);

  bool protect_;
  int depth_ = 0;
  std::vector<Range> ranges_;
};

}  // namespace gw
