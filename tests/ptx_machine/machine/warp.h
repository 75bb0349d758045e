// The machine under both engines (interpreter and translated code): a grid of blocks of warps of 32 lanes.
//
// What a launch is, who runs when, and how lanes part and meet, is here and in scheduler.cpp; what an instruction means
// is the engine's. Divergence: a warp keeps groups of lanes, each at a basic block. The group at the lowest block runs
// (the order of the text, in which nvcc puts a join behind what joins there), and groups that come to the same block
// become one. At an instruction at which lanes wait (ptx_module.h, waits()) a block begins; a group that lacks named
// lanes stays there while others run, and when no other group can run the machine reports it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/ptx_machine/ptx/ptx_module.h"

namespace gw::ptx {

constexpr unsigned kLanes = 32;
using Mask = uint32_t;  // bit l: lane l

struct Size3 {
  uint32_t x = 1, y = 1, z = 1;
  uint64_t count() const { return uint64_t(x) * y * z; }
};

struct Block;
class Memory;
class Counts;

// Where an instruction stands, for messages and counts. Lives as long as the program or the module it is of: the
// translator writes tables of them, the interpreter makes one for each instruction.
struct Site {
  const char* kernel = "";  // mangled
  const char* text = "";    // the instruction as nvcc wrote it
  const char* file = "";    // source; "" and 0 where nvcc does not say
  uint32_t line = 0;
  uint32_t ptxLine = 0;
};

// The registers of a warp, 32 lanes each, are the engine's own: `frame` points to as many bytes as it asked for.
struct Warp {
  Block* block = nullptr;
  uint32_t index = 0;  // in the block
  Mask exists = 0;     // lanes that were started: all, but in the last warp of an odd block size
  Mask exited = 0;
  void* frame = nullptr;

  struct Group {
    uint32_t block;  // the basic block it runs next
    Mask lanes;
    bool waits = false;  // it came to a waiting instruction and lacks lanes, or stands at a barrier
  };
  std::vector<Group> groups;  // ascending blocks; disjoint; with `exited` they make up `exists`

  // For the check of races: how often this warp has been ordered within itself (bar.warp, shfl, vote).
  uint32_t warpSync = 0;
};

// Why an engine returns.
enum class Stop : uint8_t {
  exited,   // no lane is left
  barrier,  // all lanes left stand at a block barrier
};

struct Launch;

struct Block {
  Launch* launch = nullptr;
  uint32_t index = 0;           // linear
  Size3 id;                     // %ctaid
  std::vector<uint8_t> shared;  // static, then dynamic
  uint32_t phase = 0;           // barriers passed
  std::vector<Warp> warps;
  bool barrierOr = false, barrierAnd = true;  // bar.red: of the lanes that arrived
};

// A kernel as an engine runs it.
struct Code {
  const char* name = "";                                            // mangled
  uint32_t parameter_bytes = 0, shared_bytes = 0, local_bytes = 0;  // static; local: of one lane, the engine keeps it
  size_t frame_bytes = 0, frame_alignment = 64;
  uint32_t basicBlocks = 0;
  // Runs the warp until it stops. Called again after a barrier was released.
  Stop (*run)(Warp&, const Code&) = nullptr;
  const void* engineOwn = nullptr;
};

enum class Order : uint8_t { ascending, reversed, shuffled };

struct Options {
  bool checkAccesses = true;  // bounds, alignment, initialised, shared size, barriers
  bool checkRaces = true;
  bool count = false;
  Order order = Order::ascending;  // of blocks, and of the warps of a block
  uint64_t seed = 1;               // of shuffled
};

struct Launch {
  const Code* code = nullptr;
  Size3 grid, block;
  uint32_t dynamicShared_bytes = 0;
  std::vector<uint8_t> parameters;  // as the kernel's parameter block
  uint64_t moduleGlobals = 0;       // where the module's variables begin: their offset_bytes count from here
  Memory* memory = nullptr;
  Counts* counts = nullptr;  // null: not counted
  Options options;
  uint64_t serial = 0;  // counts launches of this machine from 1
};

// What was found wrong, once per (kind, kernel, PTX line); the first is complete, further ones are counted.
struct Fault {
  std::string kind;  // "race", "outside an allocation", "misaligned", "read before written", "barrier", ...
  std::string text;  // one paragraph: kernel, source line, PTX line, block, lane, the other access, allocation
  uint64_t times = 1;
};

// Divergence, for engines.
struct Turn {
  uint32_t block = 0;
  Mask lanes = 0;  // 0: no group can run
};
// Takes the lowest group that does not wait. When every group waits for lanes that cannot come, that is reported once,
// and the lowest is let go on without them.
Turn nextTurn(Warp& warp);
// The lanes come to a basic block and join the group there.
void arrive(Warp& warp, uint32_t block, Mask lanes);
// At a waiting instruction of a warp (shfl, vote, match, bar.warp), which begins `block`: `named` is its member mask.
// Returns the lanes that execute it now: all that were named and have not exited; 0 when some are missing, and
// `present` was put to wait there. Lanes that are not named in a mask they execute are reported.
Mask meet(Warp& warp, uint32_t block, Mask present, Mask named, const Site& site);
// At a block barrier: the lanes wait, to go on at `next` when the block is released.
void standAtBarrier(Warp& warp, uint32_t next, Mask lanes, const Site& site);
void exitLanes(Warp& warp, Mask lanes);

// Runs all blocks one after the other. Reports through memory->report(); an access that cannot be made (outside an
// allocation) reads zeros and writes nothing, so that a run goes on to its end. Complexity: instructions executed.
void runLaunch(Launch& launch);

}  // namespace gw::ptx
