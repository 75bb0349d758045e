// PTX as nvcc writes it, parsed: what the interpreter runs and the translator turns into C++.
//
// Source of all meanings: "Parallel Thread Execution ISA", version 9.0. The parser knows the whole grammar that nvcc 13
// uses for our kernels and refuses the rest with file, line and the instruction's text; it knows nothing of meanings.
// An opcode or a modifier that no engine implements is refused by opcodes.h, at the same place, before anything runs.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gw::ptx {

// "collide.ptx, line 120: 'cp.async.ca.shared.global ...' is not known: ..."
class PtxError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The types of registers and of instructions. Untyped bits (b8 to b64) stand beside numbers of their width.
enum class Type : uint8_t { none, pred, b8, b16, b32, b64, u8, u16, u32, u64, s8, s16, s32, s64, f32, f64 };
unsigned bytesOf(Type type);  // 0 for none and pred

enum class Space : uint8_t { generic, global, shared, local, param, constant };

// A declared register, an index into Kernel::registers.
using RegisterId = uint32_t;

struct Register {
  std::string name;  // "%rd12"
  Type type;         // b16, b32, b64, f32, f64 or pred
};

// %tid.x and the others that the machine answers.
enum class Special : uint8_t {
  tid_x,
  tid_y,
  tid_z,
  ntid_x,
  ntid_y,
  ntid_z,
  ctaid_x,
  ctaid_y,
  ctaid_z,
  nctaid_x,
  nctaid_y,
  nctaid_z,
  laneid,
  warpid,
  nwarpid,
  lanemask_eq,
  lanemask_le,
  lanemask_lt,
  lanemask_ge,
  lanemask_gt
};

// A variable with an address: module globals, shared and local variables of a kernel, its parameters. `offset_bytes` is
// its place within its space: parameters in the parameter block as the launch passes it, shared variables in the
// block's shared memory with dynamic shared memory (extern) behind all others, local ones in the thread's local memory.
struct Variable {
  std::string name;
  Space space = Space::generic;
  uint32_t alignment = 1;
  uint64_t bytes = 0;  // 0 for extern shared memory: the launch says how many
  uint64_t offset_bytes = 0;
  bool isExtern = false;
  std::vector<uint8_t> initial;  // module globals only; empty: zeros
};

struct Operand {
  enum class Kind : uint8_t { reg, immediate, address, special, label, vector, sink };  // sink: "_"
  Kind kind = Kind::immediate;
  RegisterId reg = 0;    // reg; the base of an address when hasBase
  bool negated = false;  // "!%p1"
  uint64_t bits = 0;     // an immediate: its value as 64 bits, sign-extended; 0fXXXXXXXX and 0dXXXX: raw bits
  bool isFloat = false;  // ... and was written as 0f (4 bytes) or 0d (8 bytes)
  bool hasBase = false;  // an address: [reg + offset] ...
  const Variable* variable = nullptr;  // ... or [variable + offset]; as a plain operand (mov): the variable's address
  int64_t offset = 0;
  Special special{};
  uint32_t block = 0;             // label: the basic block it names
  std::vector<Operand> elements;  // vector: {%r1, %r2}; for "%p1|%p2" too
};

// Where nvcc says it comes from (.loc, with -lineinfo): the innermost place of what was inlined.
struct SourcePlace {
  std::string_view file;  // owned by the module
  uint32_t line = 0;      // 0: unknown
};

struct Instruction {
  std::string opcode;                  // "setp"
  std::vector<std::string> modifiers;  // "lt", "f32"
  std::string form;                    // opcode and modifiers with dots: "setp.lt.f32"; the key of tables and counts
  bool guarded = false;                // @%p or @!%p
  RegisterId guard = 0;
  bool guardNegated = false;
  std::vector<Operand> operands;  // destination first
  SourcePlace place;
  uint32_t ptxLine = 0;  // 1-based in the module's text
  std::string text;      // as written, for messages
};

// Straight code with one entry: [begin, end) of Kernel::instructions. A block ends behind a branch, ret or exit, before
// a label, and before and behind each instruction at which lanes wait for each other (waits()).
struct BasicBlock {
  uint32_t begin = 0, end = 0;
};

struct Kernel {
  std::string name;  // mangled, as __cudaRegisterFunction knows it
  std::vector<Variable> parameters;
  uint64_t parameter_bytes = 0;
  std::vector<Variable> shared, local;  // of its own; extern shared memory of the module is in `shared` too when used
  uint64_t shared_bytes = 0, local_bytes = 0;  // static
  uint32_t maxThreads = 0;                     // .maxntid, product; 0: not said
  std::vector<Register> registers;
  std::vector<Instruction> instructions;
  std::vector<BasicBlock> blocks;  // in the order of the text; block 0 is the entry
  uint32_t ptxLine = 0;
};

struct Module {
  std::string name;                // of the file it came from
  std::string version, target;     // "9.0", "sm_90"
  uint64_t textHash = 0;           // xxh64 of the PTX text: ties translated code to the fat binary it was made from
  std::vector<std::string> files;  // of .file, index as there; element 0 unused
  std::vector<Variable> globals;
  std::vector<Kernel> kernels;
};

// Whether lanes wait for each other there: bar, barrier, bar.warp, shfl.sync, vote.sync, match.sync.
bool waits(const Instruction& instruction);

// Pointers within a module (Operand::variable, SourcePlace::file) stay valid while it lives where it is; moving it is
// fine, copying is not. Throws PtxError. O(length).
Module parsePtx(std::string_view text, std::string name);

}  // namespace gw::ptx
