// Figures of a series, by hand and against definitions that count instead of sorting.
#include "host/platform/statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/game/profile/metrics/noise.h"

namespace gw::profile::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> upTo(int last) {
  std::vector<double> values;
  for (int i = 1; i <= last; ++i) values.push_back(i);
  return values;
}

// Hundredths, many of them equal.
std::vector<double> someValues() {
  std::vector<double> values;
  for (const int value : *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3000)))) {
    values.push_back(value / 100.0);
  }
  return values;
}

TEST(Statistics, OfFourValues) {
  const std::vector<double> values = {4, 1, 3, 2};
  EXPECT_DOUBLE_EQ(mean(values), 2.5);
  EXPECT_DOUBLE_EQ(median(values), 2.5);
  EXPECT_DOUBLE_EQ(percentile(values, 0), 1);
  EXPECT_DOUBLE_EQ(percentile(values, 25), 1.75);
  EXPECT_DOUBLE_EQ(percentile(values, 99), 3.97);
  EXPECT_DOUBLE_EQ(percentile(values, 100), 4);
  EXPECT_DOUBLE_EQ(percentile(values, 120), 4);
  EXPECT_DOUBLE_EQ(deviation(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9}), std::sqrt(32.0 / 7));
}

TEST(Statistics, OfNothingAndOfOne) {
  EXPECT_EQ(mean({}), 0);
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(percentile({}, 99), 0);
  EXPECT_EQ(meanOfWorstPercent({}), 0);
  EXPECT_EQ(deviation(std::vector<double>{7}), 0);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(percentile({7}, 99.9), 7);
  EXPECT_EQ(meanOfWorstPercent({7}), 7);
}

TEST(Statistics, LeaveOutWhatIsNoNumber) {
  const std::vector<double> values = {kNaN, 1, kNaN, 3};
  EXPECT_EQ(mean(values), 2);
  EXPECT_EQ(median(values), 2);
  EXPECT_EQ(percentile(values, 100), 3);
  EXPECT_EQ(meanOfWorstPercent(values), 3);
  EXPECT_DOUBLE_EQ(deviation(values), std::sqrt(2.0));
  EXPECT_EQ(mean(std::vector<double>{kNaN}), 0);
}

TEST(Statistics, RoundTheWorstPercentUp) {
  EXPECT_EQ(meanOfWorstPercent(upTo(100)), 100);
  EXPECT_EQ(meanOfWorstPercent(upTo(101)), 100.5);
  EXPECT_EQ(meanOfWorstPercent(upTo(200)), 199.5);
  EXPECT_EQ(meanOfWorstPercent(upTo(201)), 200);
}

// Type 7 lies at (n - 1) p: as many values are no greater, as many no less.
RC_GTEST_PROP(Percentile, liesWhereItsDefinitionSays, ()) {
  const std::vector<double> values = someValues();
  const double percent = *rc::gen::inRange(0, 1001) / 10.0;
  const double found = percentile(values, percent);
  const double place = percent / 100 * double(values.size() - 1);
  const auto under = [&](double limit) {
    return std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit; });
  };
  const auto over = [&](double limit) {
    return std::count_if(values.begin(), values.end(), [&](double v) { return v >= limit; });
  };
  RC_ASSERT(double(under(found + 1e-9)) >= std::floor(place) + 1);
  RC_ASSERT(double(over(found - 1e-9)) >= double(values.size()) - std::ceil(place));
  // Between neighbours it divides their distance as the place lies between theirs.
  const auto ranked = [&](size_t rank) {
    for (const double v : values) {
      const auto less = std::count_if(values.begin(), values.end(), [&](double w) { return w < v; });
      if (size_t(less) <= rank && rank < size_t(under(v))) return v;
    }
    return kNaN;
  };
  const double below = ranked(size_t(std::floor(place))), above = ranked(size_t(std::ceil(place)));
  RC_ASSERT(std::abs(found - (below + (above - below) * (place - std::floor(place)))) < 1e-9);
}

RC_GTEST_PROP(MeanOfWorstPercent, takesTheGreatestOneByOne, ()) {
  std::vector<double> values = someValues();
  const size_t repeats = *rc::gen::inRange(1, 40);
  const std::vector<double> once = values;
  for (size_t i = 1; i < repeats; ++i) values.insert(values.end(), once.begin(), once.end());
  const double found = meanOfWorstPercent(values);
  double sum = 0;
  size_t taken = 0;
  const size_t size = values.size();
  do {
    const auto greatest = std::max_element(values.begin(), values.end());
    sum += *greatest;
    values.erase(greatest);
    ++taken;
  } while (100 * taken < size);
  RC_ASSERT(std::abs(found - sum / double(taken)) < 1e-9);
}

// ---------------------------------------------------------------- growth

std::optional<PowerFit> fitOfPower(double factor, double exponent, double noise) {
  Noise scatter(3);
  std::vector<double> x, y;
  for (double n = 64; n <= 16384; n *= 1.4) {
    x.push_back(n);
    y.push_back(factor * std::pow(n, exponent) * std::exp(scatter.normal(0, noise)));
  }
  return fitPower(x, y);
}

TEST(FitPower, IsExactWithoutNoise) {
  const auto fit = fitOfPower(0.25, 1.5, 0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 1.5, 1e-12);
  EXPECT_NEAR(fit->factor, 0.25, 1e-12);
  EXPECT_NEAR(fit->r2, 1, 1e-12);
}

TEST(FitPower, FindsExponentsInNoise) {
  for (const double exponent : {1.0, 2.0}) {
    const auto fit = fitOfPower(0.01, exponent, 0.1);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->exponent, exponent, 0.06);  // its standard error is 0.015
    EXPECT_GT(fit->r2, 0.99);
    EXPECT_LT(fit->r2, 1);
  }
}

TEST(FitPower, SaysThatNoiseExplainsNothing) {
  const auto fit = fitOfPower(5, 0, 0.3);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->r2, 0.3);
  const auto level = fitPower(std::vector<double>{1, 2, 4}, std::vector<double>{3, 3, 3});
  ASSERT_TRUE(level);
  EXPECT_NEAR(level->exponent, 0, 1e-12);
  EXPECT_EQ(level->r2, 1);
}

TEST(FitPower, RefusesTooLittle) {
  using Values = std::vector<double>;
  EXPECT_FALSE(fitPower({}, {}));
  EXPECT_FALSE(fitPower(Values{1, 2}, Values{1, 2}));
  EXPECT_FALSE(fitPower(Values{100, 120, 149}, Values{1, 2, 3}));
  EXPECT_TRUE(fitPower(Values{100, 120, 151}, Values{1, 2, 3}));
  // Points without a logarithm count for nothing.
  EXPECT_FALSE(fitPower(Values{0, 1, 2, kNaN}, Values{1, 2, 4, 8}));
  EXPECT_FALSE(fitPower(Values{1, 2, 4}, Values{1, 0, 4}));
  const auto fit = fitPower(Values{0, 1, 2, kNaN, 4}, Values{9, 1, 2, 9, 4});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 1, 1e-12);
}

}  // namespace
}  // namespace gw::profile::test
