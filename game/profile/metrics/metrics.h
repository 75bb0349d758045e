// What a profile measures, by name: the one table that reports, comparisons and docs/guide/profile.md read.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/profile/metrics/frame.h"

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

// Counts in figures of frames: none of the warm-up, and its time is known and nothing's but the game's.
bool counts(const Frame& frame);
// Counts in figures of its stages and searches, which have times of their own: none of the warm-up, and none whose own
// time was lost. In shadow no frame has one.
bool countsForStages(const Frame& frame, bool shadow);
// What each of its ticks took: frames with several are not timed tick by tick. NaN when it simulated none.
double tick_ms(const Frame& frame);

// By name; what was not measured is absent.
using MetricValues = std::map<std::string, double, std::less<>>;

// Of one run. Frames of the warm-up count for timeToFirstFrame_ms and worstOfFirst5s_ms alone; all other metrics are
// absent when nothing else is left.
MetricValues metricsOf(const RunFrames& run);

// Frames that took over twice the median of the 60 others around them and at least 4 ms more than it: what is seen as
// a jerk. At either end, and where there are fewer, the nearest 60, or all others.
uint64_t stutters(std::span<const double> frames_ms);

}  // namespace gw::profile
