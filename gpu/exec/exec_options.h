// How a queue of a device works. None of it changes a single bit of any result.
#pragma once

#include <cstdint>

namespace gw {

// The order in which the cpu device visits items and lanes. A kernel whose result depends on it has a
// race: this is the race detector that machines without a GPU have.
enum class VisitOrder : uint32_t { forward, reversed, shuffled };

// What a Queue is made with.
struct ExecOptions {
  uint32_t threads = 0;                    // cpu device: 0 takes one per processor that this process may use
  VisitOrder order = VisitOrder::forward;  // cpu device
  bool protectMemory = false;              // cpu device: memory is PROT_NONE outside launches and declared copies
  uint32_t blockSize = 128;                // cuda device: threads per block of forEach
#ifdef NDEBUG
  bool checkLaunches = false;  // cuda device: wait for every launch, and say which one failed
#else
  bool checkLaunches = true;  // the same; in debug builds launches are checked unless told otherwise
#endif
};

}  // namespace gw
