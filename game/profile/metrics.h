// What a profile measures, by name: the one table that reports, comparisons and docs/profile.md read.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/profile/frame.h"

namespace gw::profile {

enum class Better { higher, lower, neither };

struct Metric {
  const char* name;        // as report.json has it
  const char* unit;        // "": a plain number
  const char* definition;  // one sentence
  Better better;
};

// All there are, in the order of the report.
std::span<const Metric> metrics();
// Throws std::invalid_argument for a name that is none.
const Metric& metric(std::string_view name);

// By name; what was not measured is absent.
using MetricValues = std::map<std::string, double, std::less<>>;

// Of one run. Frames of the warm-up count for timeToFirstFrame_ms and worstOfFirst5s_ms alone; all other metrics are
// absent when nothing else is left.
MetricValues metricsOf(const RunFrames& run);

// Frames that took over twice the median of the 60 around them and at least 4 ms more than it: what is seen as a jerk.
uint64_t stutters(std::span<const double> frames_ms);

}  // namespace gw::profile
