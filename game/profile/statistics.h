// Figures of a series, and how sure they are. Pure: numbers in, numbers out.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gw::profile {

// 0 for an empty series, in all of these.
double mean(std::span<const double> values);
double median(std::vector<double> values);

// The value that `percent` of the series do not exceed, between neighbours by straight interpolation (Hyndman and Fan's
// type 7). `percent` 0 to 100.
double percentile(std::vector<double> values, double percent);
// Of a series that is sorted already.
double percentileOfSorted(std::span<const double> sorted, double percent);

// The mean of the greatest 1 %, at least one value.
double meanOfWorstPercent(std::vector<double> values);

// A figure and the interval that holds its true value with 95 %.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;  // both NaN: too few runs to say
};

// Fewer runs than this make no interval: resampling a handful says less than it seems to.
inline constexpr size_t kRunsForInterval = 10;

// The mean over runs, one value each, with a percentile bootstrap over *runs*: frames of one run depend on each other.
// The same values give the same interval. `resamples` of them.
Estimate bootstrapMean(std::span<const double> runs, uint32_t resamples = 4000);

// The ratio of two means, `over / under`, of runs that were made in turn (A B A B): pairs are resampled together, so
// what drifted for both cancels. Both spans are of the same length.
Estimate bootstrapRatio(std::span<const double> over, std::span<const double> under, uint32_t resamples = 4000);

// The same of two sessions that were measured apart: both are resampled by themselves.
Estimate bootstrapRatioApart(std::span<const double> over, std::span<const double> under, uint32_t resamples = 4000);

// y = factor * x^exponent, by least squares of the logarithms. None when fewer than three points are positive, or x
// spans less than a factor of 1.5.
struct PowerFit {
  double factor, exponent;
  double r2;  // share of the variance of log y that it explains
};
std::optional<PowerFit> fitPower(std::span<const double> x, std::span<const double> y);

}  // namespace gw::profile
