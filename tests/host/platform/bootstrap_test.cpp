// How sure figures are: what resampling gives where it is known, and how often it is right.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/platform/statistics.h"
#include "tests/game/profile/metrics/noise.h"

namespace gw::profile::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isOpen(const Estimate& estimate) {
  return std::isnan(estimate.low) && std::isnan(estimate.high);
}

double width(const Estimate& estimate) {
  return estimate.high - estimate.low;
}

TEST(Bootstrap, NeedsTenRuns) {
  std::vector<double> runs(9, 4.0);
  runs.back() = 13;
  EXPECT_EQ(bootstrapMean(runs).value, 5);
  EXPECT_TRUE(isOpen(bootstrapMean(runs)));
  EXPECT_TRUE(isOpen(bootstrapRatio(runs, runs)));
  EXPECT_TRUE(isOpen(bootstrapRatioApart(runs, std::vector<double>(10, 5.0))));
  EXPECT_EQ(bootstrapRatioApart(runs, std::vector<double>(10, 5.0)).value, 1);
  runs.push_back(kNaN);
  EXPECT_TRUE(isOpen(bootstrapMean(runs)));
  runs.push_back(5);
  EXPECT_FALSE(isOpen(bootstrapMean(runs)));
}

TEST(Bootstrap, OfNothingIsNothing) {
  for (const Estimate& estimate : {bootstrapMean({}), bootstrapRatio({}, {}), bootstrapRatioApart({}, {})}) {
    EXPECT_TRUE(std::isnan(estimate.value));
    EXPECT_TRUE(isOpen(estimate));
  }
}

TEST(Bootstrap, OfEqualRunsHasNoWidth) {
  const Estimate estimate = bootstrapMean(std::vector<double>(10, 4.25));
  EXPECT_EQ(estimate.value, 4.25);
  EXPECT_EQ(estimate.low, 4.25);
  EXPECT_EQ(estimate.high, 4.25);
}

// One in ten is 1: resamples are binomial, at most 0 in 35 % and at most 2 in 93 %, at most 3 in 98.7 %.
TEST(Bootstrap, HasTheQuantilesOfTheBinomial) {
  std::vector<double> runs(10, 0.0);
  runs[7] = 1;
  const Estimate estimate = bootstrapMean(runs);
  EXPECT_DOUBLE_EQ(estimate.value, 0.1);
  EXPECT_DOUBLE_EQ(estimate.low, 0);
  EXPECT_DOUBLE_EQ(estimate.high, 0.3);
}

TEST(Bootstrap, IsTheSameForTheSameRuns) {
  Noise noise(11);
  const std::vector<double> a = noise.normals(12, 16, 1), b = noise.normals(12, 8, 1);
  for (const auto& twice : {std::pair{bootstrapMean(a), bootstrapMean(a)},
                            {bootstrapRatio(a, b), bootstrapRatio(a, b)},
                            {bootstrapRatioApart(a, b), bootstrapRatioApart(a, b)}}) {
    EXPECT_EQ(twice.first.low, twice.second.low);
    EXPECT_EQ(twice.first.high, twice.second.high);
    EXPECT_LT(twice.first.low, twice.first.value);
    EXPECT_GT(twice.first.high, twice.first.value);
  }
  EXPECT_EQ(permutationP(a, b), permutationP(a, b));
}

// In percent, how many of a thousand intervals hold the mean that the runs were drawn with.
double coverage_percent(size_t runs) {
  Noise noise(runs);
  int held = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    const Estimate estimate = bootstrapMean(noise.normals(runs, 16, 2), 1000);
    held += estimate.low <= 16 && 16 <= estimate.high;
  }
  return held / 10.0;
}

// Few runs make the interval too narrow, and its header says so: of ten it is not 95.
TEST(Bootstrap, HoldsTheMeanAboutAsOftenAsItsHeaderSays) {
  const double ofTen = coverage_percent(10), ofThirty = coverage_percent(30);
  RecordProperty("ofTen", std::to_string(ofTen));
  RecordProperty("ofThirty", std::to_string(ofThirty));
  EXPECT_NEAR(ofTen, 90, 2.5);
  EXPECT_NEAR(ofThirty, 93, 2.5);
}

// The machine becomes slower from run to run, for both alike.
TEST(BootstrapRatio, OfPairsCancelsWhatDrifts) {
  Noise noise(5);
  std::vector<double> over, under;
  for (int run = 0; run < 10; ++run) {
    const double drift = 1 + 0.1 * run;
    over.push_back(30 * drift * noise.normal(1, 0.005));
    under.push_back(10 * drift * noise.normal(1, 0.005));
  }
  const Estimate paired = bootstrapRatio(over, under), apart = bootstrapRatioApart(over, under);
  EXPECT_NEAR(paired.value, 3, 0.02);
  EXPECT_DOUBLE_EQ(paired.value, apart.value);
  EXPECT_LT(paired.low, 3);
  EXPECT_GT(paired.high, 3);
  EXPECT_LT(width(paired), 0.03);
  EXPECT_GT(width(apart), 20 * width(paired));
}

TEST(BootstrapRatio, LeavesOutPairsThatLackOne) {
  std::vector<double> over(11, 6.0), under(11, 3.0);
  over[4] = kNaN;
  under[4] = 1e6;
  EXPECT_EQ(bootstrapRatio(over, under).value, 2);
  EXPECT_FALSE(isOpen(bootstrapRatio(over, under)));
  under[5] = kNaN;
  EXPECT_TRUE(isOpen(bootstrapRatio(over, under)));
}

TEST(BootstrapRatio, OfZerosIsOne) {
  const std::vector<double> zeros(10, 0.0), ones(10, 1.0);
  std::vector<double> rare(10, 0.0);
  rare[0] = 1;
  EXPECT_EQ(bootstrapRatio(zeros, zeros).value, 1);
  EXPECT_EQ(bootstrapRatioApart(zeros, zeros).high, 1);
  EXPECT_EQ(bootstrapRatioApart(zeros, ones).high, 0);
  EXPECT_TRUE(std::isinf(bootstrapRatioApart(ones, zeros).low));
  // Some resamples have only zeros and some do not: it says that it does not know.
  EXPECT_EQ(bootstrapRatioApart(rare, zeros).low, 1);
  EXPECT_TRUE(std::isinf(bootstrapRatioApart(rare, zeros).high));
}

TEST(BootstrapRatioApart, TakesSessionsOfDifferentLength) {
  Noise noise(6);
  const Estimate ratio = bootstrapRatioApart(noise.normals(30, 10.5, 0.1), noise.normals(12, 10, 0.1));
  EXPECT_GT(ratio.low, 1.04);
  EXPECT_LT(ratio.high, 1.06);
}

// ---------------------------------------------------------------- permutations

TEST(PermutationP, CountsTheWaysOfDealing) {
  const std::vector<double> low = {1, 2, 3}, high = {4, 5, 6};
  EXPECT_NEAR(permutationP(high, low), 1.0 / 20, 0.006);  // one of the 20 ways of choosing three of six
  EXPECT_NEAR(permutationP(low, high), 1, 1e-12);         // every way exceeds it
  EXPECT_NEAR(permutationP(std::vector<double>{1, 4}, std::vector<double>{2, 3}), 4.0 / 6, 0.02);
  EXPECT_EQ(permutationP(low, low), permutationP(low, low));
  EXPECT_EQ(permutationP(std::vector<double>(5, 0.1), std::vector<double>(5, 0.1)), 1);
  EXPECT_EQ(permutationP({}, low), 1);
  EXPECT_GT(permutationP(std::vector<double>(20, 2), std::vector<double>(20, 1)), 0);
}

TEST(PermutationP, IsBelowAFifthInAFifthOfEqualSessions) {
  Noise noise(7);
  int fifth = 0, twentieth = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const std::vector<double> a = noise.normals(10, 16, 1);
    const double p = permutationP(a, noise.normals(10, 16, 1), 1000);
    fifth += p <= 0.2;
    twentieth += p <= 0.05;
  }
  EXPECT_NEAR(fifth, 200, 40);
  EXPECT_NEAR(twentieth, 50, 21);
}

}  // namespace
}  // namespace gw::profile::test
