// Prefix sums, sums and the sort of keys against plain loops.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/gpu/probes.h"
#include "tests/gpu/random_cells.h"
#include "tests/reference/gpu_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();
constexpr size_t kSizes[] = {0, 1, 2, 255, 256, 257, 1023, 1024, 1025, 2048, 100000};

TEST(Scan, IsThatOfALoop) {
  for (size_t size : kSizes) {
    const Words words = makeWords(size, size);
    EXPECT_EQ(kDevice.scan({2}, words), naive::scan(words)) << size;
  }
}

TEST(Scan, HoldsMoreBlocksThanATeamHasLanes) {
  const Words words = makeWords(300001, 8);  // 293 blocks of 1,024
  EXPECT_EQ(kDevice.scan({2}, words), naive::scan(words));
}

RC_GTEST_PROP(Scan, IsThatOfALoopForAnything, (Words words)) {
  // Short ones come from the generator; every other case is made long by repetition.
  if (words.size() % 2) {
    const Words once = words;
    for (int i = 0; i < 40; ++i) words.insert(words.end(), once.begin(), once.end());
  }
  RC_ASSERT(kDevice.scan({1}, words) == naive::scan(words));
}

RC_GTEST_PROP(Scan, KeepsPackedHalvesApart, ()) {
  // Two counts in one word, as spawning uses it: neither half runs into the other.
  const auto size = *rc::gen::inRange<size_t>(1, 3000);
  const auto lows = *rc::gen::container<std::vector<uint16_t>>(size, rc::gen::arbitrary<uint16_t>());
  const auto highs = *rc::gen::container<std::vector<uint16_t>>(size, rc::gen::arbitrary<uint16_t>());
  Words packed;
  for (size_t i = 0; i < size; ++i) packed.push_back(uint64_t(highs[i]) << 32 | lows[i]);
  const Words before = kDevice.scan({1}, packed);
  uint64_t low = 0, high = 0;
  for (size_t i = 0; i < size; ++i) {
    RC_ASSERT((before[i] & 0xFFFFFFFFu) == low);
    RC_ASSERT((before[i] >> 32) == high);
    low += lows[i];
    high += highs[i];
  }
  RC_ASSERT(before[size] == (high << 32 | low));
}

TEST(Scan, PackedHalvesReachTheirLimit) {
  Words packed(65537, 0x0000FFFF0000FFFFull);  // both totals are 2^32 - 1
  const Words before = kDevice.scan({2}, packed);
  EXPECT_EQ(before.back(), 0xFFFFFFFFFFFFFFFFull);
  EXPECT_EQ(before[65536], 0xFFFF0000FFFF0000ull);
}

TEST(Reduce, IsTheSumOfALoop) {
  for (size_t size : kSizes) {
    const Words words = makeWords(size, size + 1);
    EXPECT_EQ(kDevice.reduce({2}, words), std::accumulate(words.begin(), words.end(), uint64_t(0))) << size;
  }
}

TEST(Reduce, WrapsAround) {
  EXPECT_EQ(kDevice.reduce({1}, Words{~0ull, 2, ~0ull}), 0ull);
}

RC_GTEST_PROP(Reduce, IsTheSumOfALoopForAnything, (const Words& words)) {
  RC_ASSERT(kDevice.reduce({1}, words) == std::accumulate(words.begin(), words.end(), uint64_t(0)));
}

TEST(SortKeys, IsThatOfTheStandardLibrary) {
  for (size_t size : kSizes) {
    Words keys = makeWords(size, size + 2);
    for (size_t i = 0; i < size; ++i) keys[i] = keys[i] << 32 | (i * 2654435761u & 0xFFFFFFFFu);
    Words expected = keys;
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(std::adjacent_find(expected.begin(), expected.end()), expected.end()) << "keys have to differ";
    EXPECT_EQ(kDevice.sortKeys({2}, keys), expected) << size;
  }
}

RC_GTEST_PROP(SortKeys, IsThatOfTheStandardLibraryForAnything, ()) {
  const Words keys = *rc::gen::unique<Words>(rc::gen::arbitrary<uint64_t>());
  Words expected = keys;
  std::sort(expected.begin(), expected.end());
  RC_ASSERT(kDevice.sortKeys({1}, keys) == expected);
}

}  // namespace
}  // namespace gw::test
