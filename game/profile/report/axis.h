// An axis: from values to places, and where its ticks lie.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gw::profile {

// The span of what is to be shown.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double value);          // but for what is not finite
  void takePositive(double value);  // nor 1e-12 or more, for logarithms
  bool empty() const { return low > high; }
};

struct Tick {
  double value;
  std::string label;
};

struct Axis {
  enum class Scale { linear, logarithmic, nines };

  std::string label;  // with its unit
  Scale scale = Scale::linear;
  double low = 0, high = 1;
  std::vector<Tick> ticks = {};

  // 0 at the low end, 1 at the high one; beyond them for what lies outside, not finite for what has no place.
  double share(double value) const;
};

// From 0 to `high`, or when not `tight` to the tick above it.
Axis linearAxis(std::string label, double high, bool tight = false);
// From and to a 1, 2 or 5 times a power of ten. Both ends of the range are positive.
Axis logarithmicAxis(std::string label, const Range& range);
// Of percent: each nine more takes as much room as the one before. From 0 to 99.99.
Axis ninesAxis(std::string label);

}  // namespace gw::profile
