// The metrics of one run, from its frames.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "game/profile/metrics/metrics.h"
#include "host/platform/statistics.h"

namespace gw::profile {

namespace {

constexpr double kFirst_ms = 5000;  // worstOfFirst5s_ms
constexpr size_t kAround = 60;      // frames beside the one that may be a stutter
constexpr double kStutterTimes = 2, kStutter_ms = 4;

using Frames = std::vector<const Frame*>;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Metrics by name, as far as they are numbers: a division by nothing measures nothing.
class Filled {
 public:
  void put(const char* name, double value) {
    assert(metric(name).name);
    if (std::isfinite(value)) values[name] = value;
  }
  void putMean(const char* name, const std::vector<double>& of) {
    if (!of.empty()) put(name, mean(of));
  }

  MetricValues values;
};

// Of all frames, known values alone.
template <class Of>
std::vector<double> series(const Frames& frames, const Of& of) {
  std::vector<double> values;
  values.reserve(frames.size());
  for (const Frame* frame : frames) {
    const double value = of(*frame);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

void putStart(Filled& filled, const RunFrames& run) {
  filled.put("timeToFirstFrame_ms", run.timeToFirstFrame_ms);
  double passed_ms = 0, worst_ms = kUnknown;
  for (const Frame& frame : run.frames) {
    if (passed_ms >= kFirst_ms) break;
    if (!std::isfinite(frame.total_ms)) continue;
    worst_ms = std::fmax(worst_ms, frame.total_ms);  // of NaN and a number, the number
    passed_ms += frame.total_ms;
  }
  filled.put("worstOfFirst5s_ms", worst_ms);
}

void putFrames(Filled& filled, const Frames& frames) {
  std::vector<double> times_ms = series(frames, [](const Frame& frame) { return frame.total_ms; });
  filled.put("stutters", double(stutters(times_ms)));
  std::sort(times_ms.begin(), times_ms.end());
  const auto over = [&](double limit_ms) {
    return double(times_ms.end() - std::upper_bound(times_ms.begin(), times_ms.end(), limit_ms));
  };
  const double p99_ms = percentileOfSorted(times_ms, 99);
  filled.put("meanFps", 1e3 * double(times_ms.size()) / sum(times_ms));
  filled.putMean("frame_ms.mean", times_ms);
  filled.put("frame_ms.p50", percentileOfSorted(times_ms, 50));
  filled.put("frame_ms.p95", percentileOfSorted(times_ms, 95));
  filled.put("frame_ms.p99", p99_ms);
  filled.put("frame_ms.p99.9", percentileOfSorted(times_ms, 99.9));
  filled.put("frame_ms.longest", times_ms.back());
  filled.put("onePercentLow_fps", 1e3 / p99_ms);
  filled.put("onePercentLowMean_fps", 1e3 / meanOfWorstPercent(times_ms));
  filled.put("framesOver16_7ms", over(16.7));
  filled.put("framesOver33_3ms", over(33.3));

  const std::vector<double> live = series(frames, [](const Frame& frame) { return double(frame.live); });
  filled.putMean("liveEntities.mean", live);
  filled.put("liveEntities.least", *std::min_element(live.begin(), live.end()));
}

void putTicks(Filled& filled, const Frames& frames) {
  uint64_t ticks = 0, most = 0;
  std::vector<double> times_ms;
  for (const Frame* frame : frames) {
    ticks += frame->ticks;
    most = std::max<uint64_t>(most, frame->ticks);
    if (std::isfinite(tick_ms(*frame))) times_ms.insert(times_ms.end(), frame->ticks, tick_ms(*frame));
  }
  filled.put("ticksPerFrame.mean", double(ticks) / double(frames.size()));
  filled.put("ticksPerFrame.most", double(most));
  if (times_ms.empty()) return;
  std::sort(times_ms.begin(), times_ms.end());
  filled.put("ticksPerSecond", 1e3 * double(times_ms.size()) / sum(times_ms));
  filled.putMean("tick_ms.mean", times_ms);
  filled.put("tick_ms.p50", percentileOfSorted(times_ms, 50));
  filled.put("tick_ms.p99", percentileOfSorted(times_ms, 99));
  filled.put("tick_ms.p99.9", percentileOfSorted(times_ms, 99.9));
  filled.put("tick_ms.longest", times_ms.back());
}

void putPictures(Filled& filled, const Frames& frames) {
  filled.putMean("draw_ms.mean", series(frames, [](const Frame& frame) { return frame.draw_ms; }));
  filled.putMean("wait_ms.mean", series(frames, [](const Frame& frame) { return frame.wait_ms; }));
  filled.putMean("gl_ms.mean", series(frames, [](const Frame& frame) { return frame.gl_ms; }));
  const std::vector<double> latency_ms = series(frames, [](const Frame& frame) { return frame.latency_ms; });
  if (latency_ms.empty()) return;
  filled.put("latency_ms.p50", percentile(latency_ms, 50));
  filled.put("latency_ms.p99", percentile(latency_ms, 99));
}

// Of all ticks that were timed by stages.
std::vector<double> stage(const RunFrames& run, const Frames& frames, std::string_view name) {
  const auto found = std::find(run.stages.begin(), run.stages.end(), name);
  std::vector<double> ticks_ms;
  if (found == run.stages.end()) return ticks_ms;
  const size_t index = size_t(found - run.stages.begin());
  for (const Frame* frame : frames) {
    if (!frame->staged || index >= frame->stages_ms.size()) continue;
    ticks_ms.insert(ticks_ms.end(), frame->ticks, frame->stages_ms[index]);
  }
  return ticks_ms;
}

void putNeighbourhood(Filled& filled, const RunFrames& run, const Frames& frames) {
  const std::vector<double> upkeep_ms = stage(run, frames, "maintain");
  const std::vector<double> gathering_ms = series(frames, [](const Frame& frame) { return frame.gather_ms; });
  filled.putMean("upkeep_ms.mean", upkeep_ms);
  filled.putMean("gathering_ms.mean", gathering_ms);
  if (!upkeep_ms.empty() && !gathering_ms.empty()) {
    filled.put("upkeepAndGathering_ms.mean", mean(upkeep_ms) + mean(gathering_ms));
  }
  const auto perSearch = [&](double Frame::*of) {
    double found = 0, searches = 0;
    for (const Frame* frame : frames) {
      if (!std::isfinite(frame->*of) || !std::isfinite(frame->searching)) continue;
      found += frame->*of;
      searches += frame->searching;
    }
    return found / searches;
  };
  filled.put("candidatesPerEntity", perSearch(&Frame::candidates));
  filled.put("neighboursPerEntity", perSearch(&Frame::neighbours));
}

}  // namespace

bool counts(const Frame& frame) {
  return !frame.warmUp && !frame.disturbed && std::isfinite(frame.total_ms);
}

bool countsForStages(const Frame& frame, bool shadow) {
  return !frame.warmUp && (shadow || std::isfinite(frame.total_ms));
}

double tick_ms(const Frame& frame) {
  return frame.ticks == 0 ? kUnknown : frame.simulation_ms / frame.ticks;
}

MetricValues metricsOf(const RunFrames& run) {
  Filled filled;
  Frames staged, frames;
  for (const Frame& frame : run.frames) {
    if (countsForStages(frame, run.shadow)) staged.push_back(&frame);
    if (counts(frame)) frames.push_back(&frame);
  }
  if (!run.shadow) putStart(filled, run);
  putNeighbourhood(filled, run, staged);
  if (run.shadow || frames.empty()) return filled.values;
  putFrames(filled, frames);
  putTicks(filled, frames);
  if (run.drawn) putPictures(filled, frames);
  filled.putMean("think_ms.mean", stage(run, staged, "think"));
  filled.put("droppedTicks", run.droppedTicks);
  filled.put("launchesPerTick", run.launchesPerTick);
  return filled.values;
}

uint64_t stutters(std::span<const double> frames_ms) {
  std::vector<double> times_ms;
  std::copy_if(frames_ms.begin(), frames_ms.end(), std::back_inserter(times_ms),
               [](double time_ms) { return std::isfinite(time_ms); });
  const size_t size = times_ms.size(), window = std::min(size, kAround + 1);
  uint64_t found = 0;
  for (size_t i = 0; i < size && window > 1; ++i) {
    if (times_ms[i] < kStutter_ms) continue;  // no median is negative
    const size_t first = std::min(i - std::min(i, kAround / 2), size - window);
    std::vector<double> others(times_ms.begin() + ptrdiff_t(first), times_ms.begin() + ptrdiff_t(first + window));
    others.erase(others.begin() + ptrdiff_t(i - first));
    const double usual_ms = median(std::move(others));
    found += times_ms[i] > kStutterTimes * usual_ms && times_ms[i] >= usual_ms + kStutter_ms;
  }
  return found;
}

}  // namespace gw::profile
