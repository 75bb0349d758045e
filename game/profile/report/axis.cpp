#include "game/profile/report/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/profile/report/number_text.h"

namespace gw::profile {

namespace {

constexpr double kAboutTicks = 6;
constexpr double kMostDecadesInSteps = 3.5;  // of more only powers of ten are named
constexpr double kMostPowers = 10;           // and of more than these not every one
constexpr double kLeastPositive = 1e-12;     // below what can be measured
constexpr double kSlack = 1e-9;              // of a step, for sums that are not exact

std::string tickText(double value) {
  return std::abs(value) >= 1000 && std::abs(value) < 1e9 ? wholeText(value) : fmt::format("{:.6g}", value);
}

// 1, 2 or 5 times a power of ten, not below `least`.
double niceStep(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least * (1 - kSlack)) return digit * power;
  }
  return 10 * power;
}

// The numbers 1, 2, 5, 10, 20, 50 ... by their place; 0 is 1.
double stepAt(int place) {
  constexpr double kDigits[] = {1, 2, 5};
  const int decade = int(std::floor(place / 3.0));
  return kDigits[place - 3 * decade] * std::pow(10, decade);
}

}  // namespace

void Range::take(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void Range::takePositive(double value) {
  if (value >= kLeastPositive) take(value);
}

double Axis::share(double value) const {
  switch (scale) {
    case Scale::linear:
      return (value - low) / (high - low);
    case Scale::logarithmic:
      return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
    case Scale::nines:
      return std::log10((100 - value) / (100 - low)) / std::log10((100 - high) / (100 - low));
  }
  return 0;
}

Axis linearAxis(std::string label, double high, bool tight) {
  if (!(high > 1e-9) || !std::isfinite(high)) high = 1;
  Axis axis{std::move(label), Axis::Scale::linear, 0, high};
  const double step = niceStep(high / kAboutTicks);
  const double whole = step * std::ceil(high / step - kSlack);
  if (!tight && std::isfinite(whole)) axis.high = whole;  // the greatest numbers have no whole step above them
  for (int i = 0; i <= axis.high / step + kSlack; ++i) axis.ticks.push_back({i * step, tickText(i * step)});
  return axis;
}

Axis logarithmicAxis(std::string label, const Range& range) {
  const bool nothing = range.empty() || !(range.low > 0);
  const double least = nothing ? 1 : range.low, most = nothing ? 10 : range.high;
  int from = int(std::floor(std::log10(least))) * 3, to = int(std::ceil(std::log10(most))) * 3;
  while (stepAt(from + 1) <= least * (1 + kSlack)) ++from;
  while (stepAt(to - 1) >= most * (1 - kSlack)) --to;
  while (!std::isfinite(stepAt(to))) --to;
  while (stepAt(from) == 0) ++from;
  if (from >= to) {
    to = from + 1;
    --from;
  }
  Axis axis{std::move(label), Axis::Scale::logarithmic, stepAt(from), stepAt(to)};
  const double decades = (to - from) / 3.0;
  const bool all = decades <= kMostDecadesInSteps;
  const int named = 3 * int(std::ceil(decades / kMostPowers));  // places from one name to the next
  for (int place = from; place <= to; ++place) {
    const bool name = all || place % named == 0;
    if (name || named == 3) axis.ticks.push_back({stepAt(place), name ? tickText(stepAt(place)) : ""});
  }
  return axis;
}

Axis ninesAxis(std::string label) {
  return {std::move(label),
          Axis::Scale::nines,
          0,
          99.99,
          {{0, "0"}, {50, "50"}, {90, "90"}, {99, "99"}, {99.9, "99.9"}, {99.99, "99.99"}}};
}

}  // namespace gw::profile
