#include "gpu/math/state_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "tests/gpu/probes.h"
#include "tests/gpu/random_cells.h"

namespace gw::cpu {
namespace {

using test::Words;

TEST(StateHash, TheSumDoesNotMindTheOrder) {
  // Places and words, visited in two orders.
  const Words words = test::makeWords(10000, 1);
  std::vector<uint32_t> order(words.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto total = [&] {
    uint64_t sum = 0;
    for (uint32_t i : order) sum += hashWord(i, i % 5, words[i]);
    return sum;
  };
  const uint64_t before = total();
  std::mt19937_64 random(3);
  std::shuffle(order.begin(), order.end(), random);
  EXPECT_EQ(total(), before);
}

TEST(StateHash, EveryFlippedBitChangesTheSum) {
  Words words = test::makeWords(500, 2);
  const test::Probes device = probes();
  const uint64_t before = device.hashWords({2}, words).back();
  for (size_t i = 0; i < words.size(); ++i) {
    const uint64_t own = hashWord(uint32_t(i) / 8, i % 8, words[i]);
    for (int bit = 0; bit < 64; ++bit) {
      const uint64_t flipped = before - own + hashWord(uint32_t(i) / 8, i % 8, words[i] ^ 1ull << bit);
      ASSERT_NE(flipped, before) << "word " << i << ", bit " << bit;
    }
  }
  words[123] ^= 1;
  EXPECT_NE(device.hashWords({2}, words).back(), before);
}

TEST(StateHash, SwappedWordsChangeTheSum) {
  // Two entities that trade a value, or two fields that do.
  for (uint64_t a : {0ull, 1ull, 0x3f80000000000000ull}) {
    const uint64_t b = a + 1;
    EXPECT_NE(hashWord(1, 0, a) + hashWord(2, 0, b), hashWord(1, 0, b) + hashWord(2, 0, a));
    EXPECT_NE(hashWord(1, 0, a) + hashWord(1, 1, b), hashWord(1, 0, b) + hashWord(1, 1, a));
  }
}

TEST(StateHash, StructuredWordsDoNotCollide) {
  // What states are made of: few bits set, small numbers, neighbouring places. A million hashes of 64 bits
  // collide by chance once in 37 million such tests.
  Words hashes;
  for (uint32_t owner = 0; owner < 10000; ++owner) {
    for (uint32_t field = 0; field < 10; ++field) {
      for (uint64_t word = 0; word < 8; ++word) hashes.push_back(hashWord(owner, field, word));
      hashes.push_back(hashWord(owner, field, 0x3f800000ull << 32));
      hashes.push_back(hashWord(owner, field, uint64_t(owner) << 32 | 0xFFFF));
    }
  }
  ASSERT_EQ(hashes.size(), 1000000u);
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

TEST(StateHash, AFlippedBitReachesHalfOfAllBits) {
  uint64_t flips = 0, pairs = 0;
  for (uint32_t owner = 0; owner < 200; ++owner) {
    const uint64_t hash = hashWord(owner, 3, owner);
    for (int bit = 0; bit < 64; ++bit) {
      flips += uint64_t(std::popcount(hash ^ hashWord(owner, 3, owner ^ 1ull << bit)));
      ++pairs;
    }
  }
  EXPECT_NEAR(double(flips) / double(pairs), 32.0, 0.5);
}

TEST(StateHash, TheMixerIsSplitMix64s) {
  // The first outputs of SplitMix64 from the seed 0, whose finaliser this is.
  EXPECT_EQ(mixed(0x9E3779B97F4A7C15ull), 0xE220A8397B1DCDAFull);
  EXPECT_EQ(mixed(2 * 0x9E3779B97F4A7C15ull), 0x6E789E6AA1B965F4ull);
}

}  // namespace
}  // namespace gw::cpu
