// The largest errors of exact_math.h against double precision, and what its functions do at the edges. The
// figures in the header are these bounds: a test fails when an error passes its bound, and also when the
// bound says much more than what is measured.
#include "gpu/math/exact_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/gpu/random_cells.h"

namespace gw::cpu {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

constexpr double kSineBound = 8e-8, kArcTangentBound = 3e-7, kExponentialBound = 8.5e-8;

void expectTight(double measured, double bound) {
  testing::Test::RecordProperty("largest_error", std::to_string(measured * 1e9) + "e-9");
  EXPECT_LT(measured, bound);
  EXPECT_GT(measured, 0.8 * bound) << "the header may promise more";
}

// Calls take(x) for positive floats of every exponent up to `most`, evenly by bits, and for their opposites.
template <class Take>
void sweepBits(float most, uint32_t stride, const Take& take) {
  for (uint32_t bits = 0; bits <= bitsOf(most); bits += stride) {
    take(floatOf(bits));
    take(-floatOf(bits));
  }
}

TEST(SineCosine, ErrorsStayBelowTheBound) {
  double worst = 0;
  const auto take = [&](float x) {
    const SineCosine both = sineCosine(x);
    worst = std::max({worst, std::fabs(both.sine - std::sin(double(x))), std::fabs(both.cosine - std::cos(double(x)))});
  };
  sweepBits(8192.0f, 701, take);                                          // 3.3 million, denormals included
  for (int i = -1500000; i <= 1500000; ++i) take(float(i) * 0.0054613f);  // evenly over +-8,192
  for (int quarter = -5215; quarter <= 5215; ++quarter) {                 // around each multiple of pi / 4
    const float corner = float(quarter * 1.5707963267948966);
    for (float x : {corner, std::nextafter(corner, 0.0f), std::nextafter(corner, 9999.0f), corner + 0.785398f}) {
      if (magnitude(x) <= 8192.0f) take(x);
    }
  }
  expectTight(worst, kSineBound);
}

TEST(SineCosine, LieOnTheCircle) {
  for (int i = -100000; i <= 100000; ++i) {
    const SineCosine both = sineCosine(float(i) * 0.081f);
    ASSERT_LE(magnitude(both.sine), 1.0f + 1.2e-7f);
    ASSERT_NEAR(double(both.sine) * both.sine + double(both.cosine) * both.cosine, 1.0, 3e-7);
  }
}

TEST(SineCosine, SineIsOddAndCosineEven) {
  const auto take = [](float x) {
    ASSERT_EQ(sine(-x), -sine(x)) << x;
    ASSERT_EQ(bitsOf(cosine(-x)), bitsOf(cosine(x))) << x;
  };
  sweepBits(kLargest, 20011, take);
}

TEST(SineCosine, CountBeyondTheRangeAsItsEnd) {
  for (float x : {8192.001f, 1e10f, kLargest, kInfinity}) {
    EXPECT_EQ(sine(x), sine(8192.0f));
    EXPECT_EQ(sine(-x), sine(-8192.0f));
    EXPECT_EQ(cosine(x), cosine(8192.0f));
  }
  EXPECT_EQ(magnitude(sine(kNaN)), magnitude(sine(8192.0f)));
  EXPECT_EQ(cosine(kNaN), cosine(8192.0f));
}

TEST(SineCosine, SmallOnesAreThemselves) {
  for (float x : {1e-45f, 1.2e-38f, 1e-20f, 1e-5f}) EXPECT_EQ(sine(x), x);
  EXPECT_EQ(sine(0.0f), 0.0f);
  EXPECT_EQ(cosine(0.0f), 1.0f);
}

TEST(ArcTangent2, ErrorsStayBelowTheBound) {
  double worst = 0;
  const auto take = [&](float y, float x) {
    const double error = std::fabs(arcTangent2(y, x) - std::atan2(double(y), double(x)));
    // The angle of (-1, -0) is -pi in the library's convention: ours ignores the sign of zero.
    if (y != 0.0f || x > 0.0f) worst = std::max(worst, error);
  };
  // Directions all round at several lengths, and slopes of every exponent in all quadrants.
  for (int i = 0; i < 2000000; ++i) {
    const double angle = i * (2 * 3.141592653589793 / 2000000);
    const float size = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 1e-30f : 1e30f;
    take(size * float(std::sin(angle)), size * float(std::cos(angle)));
  }
  sweepBits(kLargest, 4001, [&](float t) {
    take(t, 1.0f);
    take(1.0f, t);
    take(t, -1.0f);
    take(-1.0f, t);
  });
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000000; ++i) {  // any two finite floats
    const float y = floatOf(uint32_t(random())), x = floatOf(uint32_t(random()));
    if (std::isfinite(x) && std::isfinite(y)) take(y, x);
  }
  expectTight(worst, kArcTangentBound);
}

TEST(ArcTangent2, KnowsTheAxesAndTheZeros) {
  for (float y : {0.0f, -0.0f}) {
    for (float x : {0.0f, -0.0f}) EXPECT_EQ(bitsOf(arcTangent2(y, x)), 0u);
    EXPECT_EQ(arcTangent2(y, 3.0f), 0.0f);
    EXPECT_EQ(arcTangent2(y, -3.0f), kPi);
  }
  EXPECT_EQ(arcTangent2(2.0f, 0.0f), 0.5f * kPi);
  EXPECT_EQ(arcTangent2(-2.0f, 0.0f), -0.5f * kPi);
  EXPECT_EQ(arcTangent2(5.0f, 5.0f), 0.25f * kPi);
  EXPECT_EQ(arcTangent2(1e-45f, 0.0f), 0.5f * kPi);
  EXPECT_EQ(arcTangent2(kLargest, 1e-45f), 0.5f * kPi);
  EXPECT_EQ(arcTangent2(1.0f, -kInfinity), kPi);
  EXPECT_EQ(arcTangent2(-kInfinity, 1.0f), -0.5f * kPi);
}

TEST(ArcTangent2, IsOddInItsFirstArgument) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200000; ++i) {
    const float y = floatOf(uint32_t(random())), x = floatOf(uint32_t(random()));
    if (!std::isfinite(x) || !std::isfinite(y) || y == 0.0f) continue;
    ASSERT_EQ(arcTangent2(-y, x), -arcTangent2(y, x));
  }
}

TEST(Exponential, RelativeErrorsStayBelowTheBound) {
  double worst = 0;
  const auto take = [&](float x) {
    const double exact = std::exp(double(x));
    worst = std::max(worst, std::fabs(exponential(x) - exact) / exact);
  };
  sweepBits(87.0f, 1009, take);
  for (int i = -1000000; i <= 1000000; ++i) take(float(i) * 8.7e-5f);
  expectTight(worst, kExponentialBound);
}

TEST(Exponential, IsClampedOutside) {
  for (float x : {87.001f, 1000.0f, kLargest, kInfinity}) {
    EXPECT_EQ(exponential(x), exponential(87.0f));
    EXPECT_EQ(exponential(-x), exponential(-87.0f));
  }
  EXPECT_EQ(exponential(kNaN), exponential(-87.0f));
  EXPECT_EQ(exponential(0.0f), 1.0f);
  EXPECT_EQ(exponential(-0.0f), 1.0f);
  EXPECT_EQ(exponential(1e-45f), 1.0f);
  EXPECT_GT(exponential(-87.0f), 0.0f);
  EXPECT_LT(exponential(87.0f), kInfinity);
}

TEST(Normalised, HasLengthOneOrNone) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100000; ++i) {
    const float x = test::between(random, -50, 50), y = test::between(random, -50, 50);
    const Float2 unit = normalised(x, y);
    ASSERT_NEAR(length(unit.x, unit.y), 1.0f, 2e-7f);
    ASSERT_NEAR(unit.x * y, unit.y * x, 1e-5f);
  }
  for (float zero : {0.0f, -0.0f, 1e-45f}) {  // the square of the last one is 0
    const Float2 unit = normalised(zero, zero);
    EXPECT_EQ(bitsOf(unit.x) | bitsOf(unit.y), 0u);
  }
}

}  // namespace
}  // namespace gw::cpu
