#include "gpu/math/fixed_sum.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "gpu/math/bits.h"

namespace gw::cpu {
namespace {

constexpr int32_t kMost = 1 << 30;
constexpr float kScale = 0x1p20f;  // terms are clamped at 1,024
constexpr float kInfinite = std::numeric_limits<float>::infinity();

TEST(FixedTerm, ClampsAtTwoToThe30) {
  for (float scale : {1.0f, kScale, 0x1p-10f}) {
    const float limit = 0x1p30f / scale;
    EXPECT_EQ(fixedTerm(limit, scale), kMost);
    EXPECT_EQ(fixedTerm(-limit, scale), -kMost);
    EXPECT_EQ(fixedTerm(std::nextafter(limit, 0.0f), scale), kMost - 64);  // the float below 2^30
    EXPECT_EQ(fixedTerm(std::nextafter(-limit, 0.0f), scale), -(kMost - 64));
    EXPECT_EQ(fixedTerm(std::nextafter(limit, kInfinite), scale), kMost);
    for (float beyond : {4 * limit, std::numeric_limits<float>::max(), kInfinite}) {
      EXPECT_EQ(fixedTerm(beyond, scale), kMost);
      EXPECT_EQ(fixedTerm(-beyond, scale), -kMost);
    }
  }
}

TEST(FixedTerm, PushesClampAtWhatTheTableSays) {
  EXPECT_EQ(fixedTerm(1024.0f, kScale), kMost);
  EXPECT_LT(fixedTerm(1023.9f, kScale), kMost);
  EXPECT_EQ(fixedTerm(0x1p-20f, kScale), 1);
  EXPECT_EQ(fixedTerm(0x1p-20f * 0.99f, kScale), 0);
}

TEST(FixedTerm, NaNCountsAsNothing) {
  EXPECT_EQ(fixedTerm(std::numeric_limits<float>::quiet_NaN(), 1.0f), 0);
  EXPECT_EQ(fixedTerm(-std::numeric_limits<float>::quiet_NaN(), kScale), 0);
  EXPECT_EQ(fixedTerm(kInfinite, 0.0f), 0);  // infinity times nothing
}

TEST(FixedTerm, ScalesInTheTableArePowersOfTwo) {
  int exponent = 0;
  EXPECT_EQ(std::frexp(kScale, &exponent), 0.5f);
}

// Any bits at all, NaN and infinities included.
RC_GTEST_PROP(FixedTerm, IsOdd, (uint32_t bits)) {
  const float value = floatOf(bits);
  RC_ASSERT(fixedTerm(-value, kScale) == -fixedTerm(value, kScale));
}

RC_GTEST_PROP(FixedTerm, TruncatesTowardsZero, (int32_t thousandths)) {
  const float value = float(thousandths) * 0.001f;
  if (std::fabs(double(value)) < 1e9) RC_ASSERT(fixedTerm(value, 1.0f) == int32_t(std::trunc(double(value))));
}

RC_GTEST_PROP(FixedSum, DoesNotMindTheOrder, (const std::vector<uint32_t>& bits, uint64_t seed)) {
  std::vector<float> terms;
  for (uint32_t word : bits) terms.push_back(floatOf(word));
  const auto total = [&] {
    FixedSum2 sum;
    for (float term : terms) sum.add(term, -0.5f * term, kScale);
    return sum;
  };
  const FixedSum2 before = total();
  std::mt19937_64 random(seed);
  std::shuffle(terms.begin(), terms.end(), random);
  const FixedSum2 after = total();
  RC_ASSERT(before.x == after.x && before.y == after.y);
  RC_ASSERT(bitsOf(before.total(kScale).x) == bitsOf(after.total(kScale).x));
}

RC_GTEST_PROP(FixedSum, PairsCancel, (const std::vector<uint32_t>& bits)) {
  FixedSum2 sum;
  for (uint32_t word : bits) {
    sum.add(floatOf(word), floatOf(~word), kScale);
    sum.add(-floatOf(word), -floatOf(~word), kScale);
  }
  RC_ASSERT(sum.x == 0 && sum.y == 0);
  RC_ASSERT(bitsOf(sum.total(kScale).x) == 0u);
}

TEST(FixedSum, AFloatSumWouldMindTheOrder) {
  const float terms[] = {1024.0f, 1e-4f, -1024.0f};
  EXPECT_NE(terms[0] + terms[1] + terms[2], terms[0] + terms[2] + terms[1]);
  FixedSum2 one, other;
  for (int i : {0, 1, 2}) one.add(terms[i], 0, kScale);
  for (int i : {0, 2, 1}) other.add(terms[i], 0, kScale);
  EXPECT_EQ(one.x, other.x);
}

TEST(FixedSum, HoldsMoreTermsThanThereAreEntities) {
  FixedSum2 sum;
  for (int i = 0; i < 1000000; ++i) sum.add(kInfinite, -kInfinite, kScale);
  EXPECT_EQ(sum.x, int64_t(kMost) * 1000000);
  EXPECT_EQ(sum.y, -int64_t(kMost) * 1000000);
  EXPECT_EQ(sum.total(kScale).x, 1024.0f * 1000000);
}

}  // namespace
}  // namespace gw::cpu
