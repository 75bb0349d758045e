// How frame times are spread: the histogram and the percentiles.
#include <algorithm>
#include <cmath>

#include "game/profile/metrics/contender_figures.h"

namespace gw::profile {

namespace {

constexpr double kShortest_ms = 1e-6;               // a clock may see no time pass, which has no logarithm
constexpr double kFewestBins = 10, kMostBins = 80;  // more than a picture shows
constexpr int kCoarsest = 5, kFinest = 320;         // bins per decade; the finest are 0.7 % wide

double edge_ms(int bin, int perDecade) {
  return std::pow(10.0, double(bin) / perDecade);
}

int binOf(double time_ms, int perDecade) {
  return int(std::floor(std::log10(time_ms) * perDecade));
}

double placed_ms(float time_ms) {
  return std::max(double(time_ms), kShortest_ms);
}

}  // namespace

std::vector<Bin> histogramOf(std::span<const float> frames_ms) {
  if (frames_ms.empty()) return {};
  const auto ends = std::minmax_element(frames_ms.begin(), frames_ms.end());
  const double least_ms = placed_ms(*ends.first), most_ms = placed_ms(*ends.second);
  const double mostBins = std::clamp(std::sqrt(double(frames_ms.size())), kFewestBins, kMostBins);
  int perDecade = kCoarsest;
  while (perDecade < kFinest && binOf(most_ms, 2 * perDecade) - binOf(least_ms, 2 * perDecade) < mostBins)
    perDecade *= 2;
  const int first = binOf(least_ms, perDecade), last = binOf(most_ms, perDecade);
  std::vector<Bin> bins;
  for (int bin = first; bin <= last; ++bin) bins.push_back({edge_ms(bin, perDecade), edge_ms(bin + 1, perDecade), 0});
  for (const float time_ms : frames_ms) ++bins[size_t(binOf(placed_ms(time_ms), perDecade) - first)].frames;
  return bins;
}

std::vector<CurvePoint> percentilesOf(std::vector<float> frames_ms) {
  if (frames_ms.empty()) return {};
  std::sort(frames_ms.begin(), frames_ms.end());
  const std::vector<double> sorted(frames_ms.begin(), frames_ms.end());
  std::vector<CurvePoint> curve;
  const auto add = [&](double percent) {
    const double beyond = double(sorted.size()) * (100 - percent) / 100;
    // Decimals as 99.9 are rounded: a thousand frames do have one beyond it.
    if (percent == 100 || beyond >= 1 - 1e-9) curve.push_back({percent, percentileOfSorted(sorted, percent)});
  };
  for (int percent = 0; percent <= 99; ++percent) add(percent);
  for (const double percent : {99.5, 99.9, 99.99, 100.0}) add(percent);
  return curve;
}

}  // namespace gw::profile
