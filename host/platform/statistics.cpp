#include "host/platform/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gw::profile {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr uint64_t kSeed = 0x6A09E667F3BCC908;  // any: that it never changes makes intervals repeatable

// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every standard library.
class Random {
 public:
  size_t below(size_t count) {
    uint64_t z = state_ += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    z ^= z >> 31;
    return size_t(((z >> 32) * count) >> 32);
  }

 private:
  uint64_t state_ = kSeed;
};

std::vector<double> known(std::span<const double> values) {
  std::vector<double> kept;
  kept.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(kept), [](double v) { return !std::isnan(v); });
  return kept;
}

double meanOfResample(const std::vector<double>& values, Random& random) {
  double sum = 0;
  for (size_t i = 0; i < values.size(); ++i) sum += values[random.below(values.size())];
  return sum / double(values.size());
}

// Counts may be zero in every run; then nothing has changed.
double ratioOf(double over, double under) {
  return over == 0 && under == 0 ? 1 : over / under;
}

template <class Resample>
Estimate bootstrap(double value, size_t runs, uint32_t resamples, const Resample& resample) {
  if (runs < kRunsForInterval || resamples == 0) return {value, kNaN, kNaN};
  Random random;
  std::vector<double> figures(resamples);
  for (double& figure : figures) figure = resample(random);
  std::sort(figures.begin(), figures.end());
  return {value, percentileOfSorted(figures, 2.5), percentileOfSorted(figures, 97.5)};
}

}  // namespace

double mean(std::span<const double> values) {
  double sum = 0;
  size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count == 0 ? 0 : sum / double(count);
}

double median(std::vector<double> values) {
  return percentile(std::move(values), 50);
}

double deviation(std::span<const double> values) {
  const std::vector<double> kept = known(values);
  if (kept.size() < 2) return 0;
  const double middle = mean(kept);
  double squares = 0;
  for (const double value : kept) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / double(kept.size() - 1));
}

double percentile(std::vector<double> values, double percent) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  std::sort(values.begin(), values.end());
  return percentileOfSorted(values, percent);
}

double percentileOfSorted(std::span<const double> sorted, double percent) {
  if (sorted.empty()) return 0;
  const double place = std::clamp(percent, 0.0, 100.0) / 100 * double(sorted.size() - 1);
  const size_t below = size_t(place);
  const double low = sorted[below], high = sorted[std::min(below + 1, sorted.size() - 1)];
  const double share = place - double(below);
  // Two infinite neighbours have no difference.
  return share == 0 || low == high ? low : low + (high - low) * share;
}

double meanOfWorstPercent(std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return 0;
  const size_t count = (values.size() + 99) / 100;
  std::nth_element(values.begin(), values.begin() + ptrdiff_t(count - 1), values.end(), std::greater<>());
  return std::accumulate(values.begin(), values.begin() + ptrdiff_t(count), 0.0) / double(count);
}

Estimate bootstrapMean(std::span<const double> runs, uint32_t resamples) {
  const std::vector<double> kept = known(runs);
  return bootstrap(kept.empty() ? kNaN : mean(kept), kept.size(), resamples,
                   [&](Random& random) { return meanOfResample(kept, random); });
}

Estimate bootstrapRatio(std::span<const double> over, std::span<const double> under, uint32_t resamples) {
  struct Pair {
    double over, under;
  };
  std::vector<Pair> pairs;
  for (size_t i = 0; i < std::min(over.size(), under.size()); ++i) {
    if (!std::isnan(over[i]) && !std::isnan(under[i])) pairs.push_back({over[i], under[i]});
  }
  // Means of as many values: their sums do.
  Pair all{};
  for (const Pair& pair : pairs) all = {all.over + pair.over, all.under + pair.under};
  return bootstrap(pairs.empty() ? kNaN : ratioOf(all.over, all.under), pairs.size(), resamples, [&](Random& random) {
    Pair sums{};
    for (size_t i = 0; i < pairs.size(); ++i) {
      const Pair& pair = pairs[random.below(pairs.size())];
      sums = {sums.over + pair.over, sums.under + pair.under};
    }
    return ratioOf(sums.over, sums.under);
  });
}

Estimate bootstrapRatioApart(std::span<const double> over, std::span<const double> under, uint32_t resamples) {
  const std::vector<double> above = known(over), below = known(under);
  if (above.empty() || below.empty()) return {kNaN, kNaN, kNaN};
  return bootstrap(ratioOf(mean(above), mean(below)), std::min(above.size(), below.size()), resamples,
                   [&](Random& random) {
                     const double upper = meanOfResample(above, random);
                     return ratioOf(upper, meanOfResample(below, random));
                   });
}

double permutationP(std::span<const double> greater, std::span<const double> lesser, uint32_t deals) {
  const std::vector<double> first = known(greater), second = known(lesser);
  if (first.empty() || second.empty()) return 1;
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  // The sum of all stays, so the sum of the first decides which difference of means is greater.
  const double lies = std::accumulate(first.begin(), first.end(), 0.0);
  double size = 0;
  for (const double value : all) size += std::abs(value);
  const double reached = lies - 1e-12 * size;  // equal sums, added in another order, are equal
  Random random;
  uint32_t asFar = 0;
  for (uint32_t deal = 0; deal < deals; ++deal) {
    double sum = 0;
    for (size_t i = 0; i < first.size(); ++i) {
      std::swap(all[i], all[i + random.below(all.size() - i)]);
      sum += all[i];
    }
    asFar += sum >= reached;
  }
  // The way they lie is one of the ways: a p of zero would claim too much (Phipson and Smyth 2010).
  return (1 + double(asFar)) / (1 + double(deals));
}

std::optional<PowerFit> fitPower(std::span<const double> x, std::span<const double> y) {
  std::vector<double> logX, logY;
  for (size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!(x[i] > 0 && y[i] > 0 && std::isfinite(x[i]) && std::isfinite(y[i]))) continue;
    logX.push_back(std::log(x[i]));
    logY.push_back(std::log(y[i]));
  }
  if (logX.size() < 3) return std::nullopt;
  const auto [least, most] = std::minmax_element(logX.begin(), logX.end());
  if (*most - *least < std::log(1.5)) return std::nullopt;
  const double meanX = mean(logX), meanY = mean(logY);
  double xx = 0, xy = 0, yy = 0;
  for (size_t i = 0; i < logX.size(); ++i) {
    xx += (logX[i] - meanX) * (logX[i] - meanX);
    xy += (logX[i] - meanX) * (logY[i] - meanY);
    yy += (logY[i] - meanY) * (logY[i] - meanY);
  }
  const double exponent = xy / xx;
  // A level series is explained in full by the exponent 0.
  const double r2 = yy < 1e-20 ? 1 : xy * xy / (xx * yy);
  return PowerFit{std::exp(meanY - exponent * meanX), exponent, r2};
}

}  // namespace gw::profile
