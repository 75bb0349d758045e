#include "gpu/exec/buffer.h"
#include "tests/gpu/arithmetic/blocks.h"
#include "tests/gpu/arithmetic/inputs.h"

namespace gw::GW_DEVICE {
namespace {

using test::Blocks;
using test::Computed;
using test::kBlockInputs;
using test::Operations;

GW_FN Computed compute(const Blocks& blocks, uint64_t input) {
  Computed computed;
  if (blocks.operations == Operations::pairs) {
    const Float2 pair = pairOf(input);
    computed = {bitsOf(pair.x),
                bitsOf(pair.y),
                {canonicalBits(pair.x + pair.y), canonicalBits(pair.x - pair.y), canonicalBits(pair.x * pair.y),
                 canonicalBits(pair.x / pair.y)}};
  } else {
    const float a = rootOf(input);
    computed = {bitsOf(a), 0, {canonicalBits(sqrtf(a)), 0, 0, 0}};
  }
  if (input == blocks.spoilt) computed.results[blocks.operations == Operations::pairs ? 3 : 0] ^= 1u;
  return computed;
}

// One item: one block.
struct HashBlock {
  uint64_t* hashes;
  Blocks blocks;
  GW_BODY void operator()(uint32_t i) const {
    const uint64_t begin = uint64_t(blocks.first + i) * kBlockInputs;
    uint64_t hash = 0;
    for (uint32_t k = 0; k < kBlockInputs; ++k) hash = withResults(hash, compute(blocks, begin + k));
    hashes[i] = hash;
  }
};

std::vector<uint64_t> hashBlocks(const ExecOptions& options, const Blocks& blocks) {
  Queue queue(options);
  Buffer<uint64_t> hashes(queue, blocks.count);
  forEach(queue, Count{blocks.count}, HashBlock{hashes.data(), blocks});
  return hashes.download();
}

// One item: one input.
struct ShowInput {
  Computed* results;
  Blocks blocks;
  GW_BODY void operator()(uint32_t i) const { results[i] = compute(blocks, uint64_t(blocks.first) * kBlockInputs + i); }
};

std::vector<Computed> showBlocks(const ExecOptions& options, const Blocks& blocks) {
  Queue queue(options);
  Buffer<Computed> results(queue, size_t(blocks.count) * kBlockInputs);
  forEach(queue, Count{blocks.count * kBlockInputs}, ShowInput{results.data(), blocks});
  return results.download();
}

}  // namespace

test::Arithmetic arithmetic() {
  return {hashBlocks, showBlocks};
}

}  // namespace gw::GW_DEVICE
