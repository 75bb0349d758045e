#include <cmath>
#include <thread>

#include "tests/gpu/arithmetic/inputs.h"

namespace gw::test {
namespace {

using namespace cpu;  // the inputs and the hash

uint32_t rounded(double value) {
  return canonicalBits(float(value));
}

Computed compute(const Blocks& blocks, uint64_t input) {
  if (blocks.operations == Operations::roots) {
    const float a = rootOf(input);
    return {bitsOf(a), 0, {rounded(std::sqrt(double(a))), 0, 0, 0}};
  }
  const Float2 pair = pairOf(input);
  const double a = pair.x, b = pair.y;
  return {bitsOf(pair.x), bitsOf(pair.y), {rounded(a + b), rounded(a - b), rounded(a * b), rounded(a / b)}};
}

std::vector<uint64_t> hashBlocks(const ExecOptions& options, const Blocks& blocks) {
  std::vector<uint64_t> hashes(blocks.count);
  const uint32_t threads = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> workers;
  for (uint32_t t = 0; t < threads; ++t) {
    workers.emplace_back([&, t] {
      for (uint32_t i = t; i < blocks.count; i += threads) {
        const uint64_t begin = uint64_t(blocks.first + i) * kBlockInputs;
        for (uint32_t k = 0; k < kBlockInputs; ++k) hashes[i] = withResults(hashes[i], compute(blocks, begin + k));
      }
    });
  }
  for (std::thread& worker : workers) worker.join();
  return hashes;
}

std::vector<Computed> showBlocks(const ExecOptions&, const Blocks& blocks) {
  std::vector<Computed> results;
  const uint64_t begin = uint64_t(blocks.first) * kBlockInputs;
  for (uint64_t i = 0; i < uint64_t(blocks.count) * kBlockInputs; ++i) results.push_back(compute(blocks, begin + i));
  return results;
}

}  // namespace

Arithmetic arithmeticInDoubles() {
  return {hashBlocks, showBlocks};
}

}  // namespace gw::test
