// The arithmetic on which everything rests, computed by a device: + - * / of pairs of floats and square roots, from
// numbered inputs. A block of inputs becomes one hash, so that thousands of millions of results can be compared.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/exec/exec_options.h"

namespace gw::test {

enum class Operations : uint32_t { pairs, roots };

inline constexpr uint32_t kBlockInputs = 4096;  // behind one hash
inline constexpr uint32_t kResults = 4;         // of one input: a + b, a - b, a * b, a / b; of a root the first only
inline constexpr uint64_t kNotSpoilt = ~0ull;

struct Blocks {
  Operations operations;
  uint32_t first, count;
  // The number of an input whose last result is made wrong: how tests see that a difference is found.
  uint64_t spoilt = kNotSpoilt;
};

// As bits; all kinds of NaN are one, because their payloads differ between processors.
struct Computed {
  uint32_t a, b;
  uint32_t results[kResults];
};

// One hash per block; or all that was computed, for a look at a block whose hash differs.
struct Arithmetic {
  std::vector<uint64_t> (*hashes)(const ExecOptions&, const Blocks&);
  std::vector<Computed> (*results)(const ExecOptions&, const Blocks&);
};

// The same by rounding doubles once, which is right for these operations: 53 bits are more than twice 24 and two.
// Shares only the inputs and the hash with the kernels. Threads: 0 takes one per processor.
Arithmetic arithmeticInDoubles();

}  // namespace gw::test

namespace gw::cpu {
test::Arithmetic arithmetic();
}
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
test::Arithmetic arithmetic();
}
#endif
