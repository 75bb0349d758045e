// Figures of a series, and how sure they are. Pure: numbers in, numbers out.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace gw::profile {

// NaN is left out, in all of this file; of pairs, both of it. Down to the next line across, an empty series has 0.

double mean(std::span<const double> values);
double median(std::vector<double> values);
// Of a sample: divided by one less than its size. 0 for fewer than two.
double deviation(std::span<const double> values);

// The value that `percent` of the series do not exceed, between neighbours by straight interpolation (Hyndman and Fan's
// type 7). `percent` 0 to 100.
double percentile(std::vector<double> values, double percent);
// Of a series that is sorted already and has no NaN.
double percentileOfSorted(std::span<const double> sorted, double percent);

// The mean of the greatest 1 %, their number rounded up: of 101 values the greatest two.
double meanOfWorstPercent(std::vector<double> values);

// ---------------------------------------------------------------- how sure

// A figure and its interval of 95 %. Resampled from few runs such an interval is a little too narrow: of ten runs it
// holds the true mean with about 90 % (the test of its coverage has the figure), of thirty with about 93 %.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;  // both NaN: too few runs to say; the value too: there are none
};
inline constexpr Estimate kNoEstimate{std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::quiet_NaN()};

// Fewer runs than this make no interval: resampling a handful says less than it seems to.
inline constexpr size_t kRunsForInterval = 10;

// The mean over runs, one value each, with a percentile bootstrap over *runs*: frames of one run depend on each other.
// The same values give the same interval. `resamples` of them.
Estimate bootstrapMean(std::span<const double> runs, uint32_t resamples = 4000);

// The ratio of two means, `over / under`, of runs that were made in turn (A B A B): pairs are resampled together, so
// what drifted for both cancels. What one has beyond the other's length is left out. A ratio of two zeros is 1, in this
// and the next.
Estimate bootstrapRatio(std::span<const double> over, std::span<const double> under, uint32_t resamples = 4000);

// The same of two sessions that were measured apart: both are resampled by themselves.
Estimate bootstrapRatioApart(std::span<const double> over, std::span<const double> under, uint32_t resamples = 4000);

// How often chance alone would do it: the share of ways of dealing all values out to the two series in which the mean
// of `greater` exceeds that of `lesser` by as much as it does, the way they lie included. Exact whatever the values'
// distribution is; of `deals` random ways, always the same ones. 1 when either is empty.
double permutationP(std::span<const double> greater, std::span<const double> lesser, uint32_t deals = 20000);

// ---------------------------------------------------------------- growth

// y = factor * x^exponent, by least squares of the logarithms. None when fewer than three points are positive, or x
// spans less than a factor of 1.5.
struct PowerFit {
  double factor, exponent;
  double r2;  // share of the variance of log y that it explains
};
std::optional<PowerFit> fitPower(std::span<const double> x, std::span<const double> y);

}  // namespace gw::profile
