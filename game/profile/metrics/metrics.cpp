#include "game/profile/metrics/metrics.h"

#include <algorithm>
#include <stdexcept>

namespace gw::profile {

namespace {

constexpr Better kHigher = Better::higher, kLower = Better::lower, kNeither = Better::neither;

// docs/guide/profile.md has the same table; a test compares them.
constexpr Metric kMetrics[] = {
    {"meanFps", "frames/s", "Frames divided by the sum of their times.", kHigher},
    {"frame_ms.mean", "ms", "The mean frame time.", kLower},
    {"frame_ms.p50", "ms", "The median frame time.", kLower},
    {"frame_ms.p95", "ms", "The time that 95 % of the frames do not exceed.", kLower},
    {"frame_ms.p99", "ms", "The time that 99 % of the frames do not exceed.", kLower},
    {"frame_ms.p99.9", "ms", "The time that 99.9 % of the frames do not exceed.", kLower},
    {"frame_ms.longest", "ms", "The longest frame time.", kLower},
    {"onePercentLow_fps", "frames/s", "1000 divided by `frame_ms.p99`.", kHigher},
    {"onePercentLowMean_fps", "frames/s",
     "1000 divided by the mean of the longest 1 % of the frame times, their number rounded up.", kHigher},
    {"framesOver16_7ms", "", "Frames that took more than 16.7 ms.", kLower},
    {"framesOver33_3ms", "", "Frames that took more than 33.3 ms.", kLower},
    {"stutters", "",
     "Frames that took over twice the median of the 60 others around them, and at least 4 ms more than it.", kLower},
    {"ticksPerFrame.mean", "", "Simulated ticks divided by frames.", kNeither},
    {"ticksPerFrame.most", "", "The most ticks that one frame simulated.", kNeither},
    {"droppedTicks", "", "Ticks that a paced run gave up because it could not catch up with real time.", kLower},
    {"latency_ms.p50", "ms", "The median time from taking an input to having handed over the picture that it changed.",
     kLower},
    {"latency_ms.p99", "ms",
     "The time from taking an input to having handed over its picture that 99 % of the frames do not exceed.", kLower},
    {"timeToFirstFrame_ms", "ms",
     "The time from the start of the run to its first picture, or tick where none is drawn.", kLower},
    {"worstOfFirst5s_ms", "ms",
     "The longest of the frames, warm-up included, before which fewer than 5 s of frame time had passed.", kLower},
    {"ticksPerSecond", "ticks/s",
     "Simulated ticks divided by the sum of the times that frames spent on simulating them.", kHigher},
    {"tick_ms.mean", "ms", "The sum of the times that frames spent on simulating, divided by their ticks.", kLower},
    {"tick_ms.p50", "ms", "The median tick time; ticks of one frame share its time evenly, in all of `tick_ms`.",
     kLower},
    {"tick_ms.p99", "ms", "The time that 99 % of the ticks do not exceed.", kLower},
    {"tick_ms.p99.9", "ms", "The time that 99.9 % of the ticks do not exceed.", kLower},
    {"tick_ms.longest", "ms", "The longest tick time.", kLower},
    {"draw_ms.mean", "ms", "The mean time of a frame that the processor spent on draw lists and the calls of OpenGL.",
     kLower},
    {"wait_ms.mean", "ms",
     "The mean time of a frame spent handing its picture over; offscreen, waiting until it was whole.", kLower},
    {"gl_ms.mean", "ms", "The mean time of the draws of a frame by the timer queries of OpenGL.", kLower},
    {"upkeep_ms.mean", "ms",
     "The mean time of the stage `maintain`, which keeps the neighbourhood structure, of the ticks timed by stages.",
     kLower},
    {"think_ms.mean", "ms", "The mean time of the stage `think`, of the ticks timed by stages.", kLower},
    {"gathering_ms.mean", "ms",
     "The mean time in which all enemies find their neighbours once, without adding up what they found.", kLower},
    {"upkeepAndGathering_ms.mean", "ms", "`upkeep_ms.mean` plus `gathering_ms.mean`: what neighbours cost in a tick.",
     kLower},
    {"candidatesPerEntity", "", "Entities that a search tests: all candidates divided by all searches.", kLower},
    {"neighboursPerEntity", "", "Entities that a search finds: all neighbours divided by all searches.", kNeither},
    {"launchesPerTick", "", "Kernels launched in a tick.", kLower},
    {"liveEntities.mean", "", "The mean number of live enemies, over frames.", kNeither},
    {"liveEntities.least", "", "The least number of live enemies at the end of a frame.", kNeither},
};

}  // namespace

std::span<const Metric> metrics() {
  return kMetrics;
}

const Metric& metric(std::string_view name) {
  const auto found =
      std::find_if(std::begin(kMetrics), std::end(kMetrics), [&](const Metric& m) { return name == m.name; });
  if (found == std::end(kMetrics)) throw std::invalid_argument("no metric is called " + std::string(name));
  return *found;
}

}  // namespace gw::profile
