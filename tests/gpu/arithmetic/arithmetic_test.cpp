// What gw_arithmetic rests on: inputs of every kind, results that are right, and differences that are found.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "tests/gpu/arithmetic/comparison.h"

namespace gw::test {
namespace {

constexpr uint32_t kBlocks = 64;

Comparison compareWithDoubles(Operations operations, uint64_t spoilt) {
  return compare({"the cpu device", cpu::arithmetic(), spoilt}, {"doubles", arithmeticInDoubles()}, operations,
                 kBlocks * kBlockInputs);
}

TEST(Arithmetic, TheCpuDeviceRoundsAsDoublesDo) {
  for (const Operations operations : {Operations::pairs, Operations::roots}) {
    const Comparison comparison = compareWithDoubles(operations, kNotSpoilt);
    EXPECT_EQ(comparison.first, "");
    EXPECT_EQ(comparison.differingBlocks, 0u);
    EXPECT_EQ(comparison.inputs, kBlocks * kBlockInputs);
  }
}

TEST(Arithmetic, OneWrongResultIsFoundAndNamed) {
  const uint64_t last = kBlocks * kBlockInputs - 1;
  const Comparison pairs = compareWithDoubles(Operations::pairs, last);
  EXPECT_EQ(pairs.differingBlocks, 1u);
  EXPECT_NE(pairs.first.find(" / 0x"), std::string::npos) << pairs.first;
  EXPECT_NE(pairs.first.find("on the cpu device, 0x"), std::string::npos) << pairs.first;
  const Comparison roots = compareWithDoubles(Operations::roots, 0);
  EXPECT_EQ(roots.differingBlocks, 1u);
  EXPECT_EQ(roots.first.rfind("sqrt 0x00000000 (0) is 0x00000001", 0), 0u) << roots.first;
}

TEST(Arithmetic, InputsAreOfEveryKind) {
  std::set<int> kinds;
  uint32_t close = 0;
  const auto results = cpu::arithmetic().results({}, {Operations::pairs, 0, kBlocks});
  for (const Computed& c : results) {
    kinds.insert(std::fpclassify(std::bit_cast<float>(c.a)));
    const int apart = int(c.a >> 23 & 255) - int(c.b >> 23 & 255);
    close += std::abs(apart) <= 24;
  }
  EXPECT_EQ(kinds, (std::set<int>{FP_NORMAL, FP_SUBNORMAL, FP_ZERO, FP_INFINITE, FP_NAN}));
  EXPECT_GT(close, results.size() / 2) << "too few sums that round";
}

TEST(Arithmetic, RootsNeverRepeat) {
  std::set<uint32_t> seen;
  for (const Computed& c : cpu::arithmetic().results({}, {Operations::roots, 7, 2})) seen.insert(c.a);
  EXPECT_EQ(seen.size(), 2 * kBlockInputs);
}

}  // namespace
}  // namespace gw::test
