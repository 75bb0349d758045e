// Memory of the cpu device. It belongs to the kernels: with protection on, host code that reads or writes
// it outside a launch or a declared copy dies with SIGSEGV, just as it would on a real GPU.
#pragma once

#include <cstddef>
#include <vector>

namespace gw {

// Owns what it gave out, and frees it at its end.
class GuardedMemory {
 public:
  // protect: closed to the host but for the time of an Access.
  explicit GuardedMemory(bool protect) : protect_(protect) {}
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  // Zeroed, page-aligned. Throws std::runtime_error with a sentence when the machine has no more.
  void* allocate(size_t bytes);
  // Of a pointer from allocate(); null does nothing.
  void release(void* pointer);

  // Whole pages each, in the order in which they were allocated.
  struct Range {
    void* start;   // of the first page
    size_t bytes;  // a multiple of a page
  };
  // What is allocated now.
  const std::vector<Range>& ranges() const { return ranges_; }

  // Opens all of it for as long as the object lives; nests.
  class Access {
   public:
    // Opens.
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
