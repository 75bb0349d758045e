#include "tests/gpu/arithmetic/comparison.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace gw::test {
namespace {

constexpr uint32_t kBlocksAtATime = 1u << 15;

std::string asText(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  char text[60];
  std::snprintf(text, sizeof text, "0x%08x (%.9g)", bits, double(value));
  return text;
}

std::string firstDifference(const Side& expected, const Side& actual, Blocks block) {
  block.spoilt = expected.spoilt;
  const std::vector<Computed> mine = expected.arithmetic.results({}, block);
  block.spoilt = actual.spoilt;
  const std::vector<Computed> theirs = actual.arithmetic.results({}, block);
  const std::string where = " of input " + std::to_string(uint64_t(block.first) * kBlockInputs);
  for (size_t i = 0; i < mine.size(); ++i) {
    if (mine[i].a != theirs[i].a || mine[i].b != theirs[i].b) return "the operands" + where + " + " + std::to_string(i);
    for (uint32_t k = 0; k < kResults; ++k) {
      if (mine[i].results[k] == theirs[i].results[k]) continue;
      const std::string operation = block.operations == Operations::roots
                                        ? "sqrt " + asText(mine[i].a)
                                        : asText(mine[i].a) + " " + "+-*/"[k] + " " + asText(mine[i].b);
      return operation + " is " + asText(mine[i].results[k]) + " on " + expected.name + ", " +
             asText(theirs[i].results[k]) + " on " + actual.name;
    }
  }
  return "the hash of the block" + where + ", but no result in it when computed again";
}

}  // namespace

Comparison compare(const Side& expected, const Side& actual, Operations operations, uint64_t inputs) {
  Comparison comparison;
  const uint32_t blocks = uint32_t((inputs + kBlockInputs - 1) / kBlockInputs);
  for (uint32_t first = 0; first < blocks; first += kBlocksAtATime) {
    const uint32_t count = std::min(kBlocksAtATime, blocks - first);
    const auto mine = expected.arithmetic.hashes({}, {operations, first, count, expected.spoilt});
    const auto theirs = actual.arithmetic.hashes({}, {operations, first, count, actual.spoilt});
    for (uint32_t i = 0; i < count; ++i) {
      if (mine[i] == theirs[i]) continue;
      if (comparison.differingBlocks++ == 0)
        comparison.first = firstDifference(expected, actual, {operations, first + i, 1});
    }
    comparison.inputs += uint64_t(count) * kBlockInputs;
  }
  return comparison;
}

}  // namespace gw::test
