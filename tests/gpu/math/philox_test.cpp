// The known answers of the authors' own library (Random123, kat_vectors), and draws to [0, 1).
#include "gpu/math/philox.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "tests/gpu/probes.h"

namespace gw::test {
namespace {

struct KnownAnswer {
  Uint4 counter;
  uint64_t key;
  Uint4 answer;
};

constexpr uint32_t kOnes = 0xFFFFFFFFu;
constexpr KnownAnswer kKnown[] = {
    {{0, 0, 0, 0}, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
    {{kOnes, kOnes, kOnes, kOnes}, ~0ull, {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
    {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
     0x299f31d0a4093822ull,
     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
};

TEST(Philox, GivesTheKnownAnswers) {
  const Probes device = cpu::probes();
  for (const KnownAnswer& known : kKnown) {
    const Uint4 drawn = device.philox({1}, known.key, {known.counter})[0];
    EXPECT_EQ(std::memcmp(&drawn, &known.answer, sizeof drawn), 0)
        << std::hex << drawn.x << ' ' << drawn.y << ' ' << drawn.z << ' ' << drawn.w;
  }
}

TEST(Philox, EveryPartOfKeyAndCounterMatters) {
  std::set<uint64_t> seen;
  const auto see = [&](uint64_t key, Uint4 counter) {
    const Uint4 drawn = cpu::philox(key, counter);
    seen.insert(uint64_t(drawn.x) << 32 | drawn.y);
  };
  see(0, {0, 0, 0, 0});
  for (int bit = 0; bit < 64; ++bit) see(1ull << bit, {0, 0, 0, 0});
  for (int bit = 0; bit < 32; ++bit) {
    see(0, {1u << bit, 0, 0, 0});
    see(0, {0, 1u << bit, 0, 0});
    see(0, {0, 0, 1u << bit, 0});
    see(0, {0, 0, 0, 1u << bit});
  }
  EXPECT_EQ(seen.size(), 1u + 64 + 4 * 32);
}

TEST(UnitFloat, SpansZeroToBelowOne) {
  EXPECT_EQ(cpu::unitFloat(0), 0.0f);
  EXPECT_EQ(cpu::unitFloat(255), 0.0f);
  EXPECT_EQ(cpu::unitFloat(256), 0x1p-24f);
  EXPECT_EQ(cpu::unitFloat(0x80000000u), 0.5f);
  EXPECT_EQ(cpu::unitFloat(kOnes), 1.0f - 0x1p-24f);
}

TEST(UnitFloat, IsEven) {
  uint32_t bins[64] = {};
  constexpr uint32_t kDraws = 64 * 10000;
  for (uint32_t i = 0; i < kDraws; ++i) ++bins[uint32_t(cpu::unitFloat(cpu::philox(7, {i, 0, 0, 0}).w) * 64)];
  // 10,000 per bin with a standard deviation of 99: six of those are never passed by chance.
  for (uint32_t count : bins) EXPECT_NEAR(count, 10000.0, 600.0);
}

}  // namespace
}  // namespace gw::test
