// The machine's memory: allocations, what is known of each byte, and the checks on every access.
//
// Global memory is one reserved range of addresses, so that what is known of a word (its shadow) is found by
// arithmetic. Host memory that a kernel may touch (OpenGL's mapped buffers) is registered as a foreign range and
// checked for bounds.
//
// Races, by happens-before: within a launch two accesses of one word, at least one of them a plain write, are a race
// unless ordered by (a) the same lane, (b) a block barrier between them (Block::phase), (c) in one warp bar.warp.sync,
// shfl.sync or vote.sync (Warp::warpSync), (d) a release and an acquire: a fence, then an atomic, volatile or relaxed
// access of word W here, and such an access of W and then a fence there (vector clocks per block). A lane's atomic on W
// orders its own later accesses of W behind all earlier atomics on W. Launches are ordered.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/ptx_machine/machine/warp.h"

namespace gw::ptx {

enum class Access : uint8_t {
  plain,
  relaxed
};  // relaxed: atom, red, volatile, .relaxed; never a race among themselves

// One memory instruction of a warp. addresses[l] and data of lane l matter where the mask has bit l.
struct Request {
  const Site* site;
  Space space;  // of the address; generic ones are resolved by where they point
  Access access;
  uint32_t bytes;  // of all elements of one lane: 1 to 16
  Mask lanes;
  const uint64_t* addresses;  // [32]; shared: offsets in the block's shared memory; local: offsets in the lane's own
};

class Memory {
 public:
  Memory();
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  // Aligned to 256 bytes as cudaMalloc's are; never written; nullptr when the range is used up. `name` is for messages.
  void* allocate(size_t bytes, std::string name);
  bool release(void* pointer);  // false: not the beginning of an allocation
  void registerForeign(void* pointer, size_t bytes, std::string name);
  void unregisterForeign(void* pointer);
  // Copies and memsets of the host count as writes, ordered before all later launches.
  void hostWrote(void* pointer, size_t bytes);
  // They are as never written again: a buffer that OpenGL hands over to be rewritten.
  void hostForgot(void* pointer, size_t bytes);
  bool owns(const void* pointer) const;

  void beginLaunch(Launch& launch);
  void endLaunch(Launch& launch);
  void beginBlock(Block& block);
  void endBlock(Block& block);

  // Each returns the lanes whose access may be made; what is wrong is reported. Called by engines before they touch
  // memory, with checks on or off (off: the lanes as they are, at once).
  Mask checkRead(Warp& warp, const Request& request);
  Mask checkWrite(Warp& warp, const Request& request);
  Mask checkAtomic(Warp& warp, const Request& request);
  void fence(Warp& warp, Mask lanes, bool wholeGpu);  // membar.gl or .sys: true; membar.cta: false

  // Where the bytes are on the host, after a check. Local memory is the engine's own business and is not asked for
  // here.
  uint8_t* pointer(Warp& warp, Space space, uint64_t address);

  void report(Warp* warp, const Site& at, unsigned lane, std::string kind, std::string what);
  const std::vector<Fault>& faults() const;
  void clearFaults();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gw::ptx
