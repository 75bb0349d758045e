#include "game/profile/metrics/contender_figures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace gw::profile {

namespace {

constexpr uint32_t kTicksPerSecond = 60;  // of game time
constexpr double kBinsPerDoubling = 4;    // of live enemies
constexpr size_t kLeastTicks = 10;        // of such a bin: the median of fewer is noise

uint32_t secondOf(const Frame& frame) {
  return (std::max(frame.tick, 1u) - 1) / kTicksPerSecond;  // ticks 1 to 60 are the first
}

std::vector<double> doubles(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

// Of one metric, a value of each run; NaN where it was not measured.
std::vector<double> overRuns(const std::vector<MetricValues>& runs, std::string_view name) {
  std::vector<double> values;
  for (const MetricValues& run : runs) {
    const auto found = run.find(name);
    values.push_back(found == run.end() ? kUnknown : found->second);
  }
  return values;
}

}  // namespace

void ContenderFigures::Sum::add(double value, uint64_t times) {
  if (!std::isfinite(value)) return;
  total += value * double(times);
  count += times;
}

double ContenderFigures::Sum::mean() const {
  return count == 0 ? kUnknown : total / double(count);
}

ContenderFigures::ContenderFigures(std::string name, std::string about)
    : name_(std::move(name)), about_(std::move(about)) {}

void ContenderFigures::checkKind(const RunFrames& run) {
  if (runs_.empty()) shadow_ = run.shadow;
  if (shadow_ != run.shadow) throw std::invalid_argument(name_ + ": some runs are shadows and some are not");
  if (run.stages.empty()) return;
  if (stages_.empty()) {
    stages_ = run.stages;
    stages_ms_.resize(stages_.size());
  }
  if (stages_ != run.stages) throw std::invalid_argument(name_ + ": its runs differ in their stages");
}

void ContenderFigures::add(const RunFrames& run) {
  checkKind(run);
  runs_.push_back(metricsOf(run));
  addStages(run);
  if (run.shadow) return;
  addSeconds(run);
  for (const Frame& frame : run.frames) {
    if (!counts(frame)) continue;
    frames_ms_.push_back(float(frame.total_ms));
    const double time_ms = tick_ms(frame);
    if (frame.live == 0 || !std::isfinite(time_ms)) continue;  // no enemies: no place on a logarithmic axis
    LiveBin& bin = liveBins_[int(std::floor(kBinsPerDoubling * std::log2(double(frame.live))))];
    bin.ticks_ms.insert(bin.ticks_ms.end(), frame.ticks, float(time_ms));
    bin.live.add(frame.live, frame.ticks);
  }
}

void ContenderFigures::addStages(const RunFrames& run) {
  std::vector<Sum> ticks(stages_.size());
  for (const Frame& frame : run.frames) {
    if (!frame.staged || !countsForStages(frame, run.shadow)) continue;
    for (size_t i = 0; i < std::min(ticks.size(), frame.stages_ms.size()); ++i) {
      ticks[i].add(frame.stages_ms[i], frame.ticks);
    }
  }
  for (size_t i = 0; i < ticks.size(); ++i) stages_ms_[i].add(ticks[i].mean());
}

void ContenderFigures::addSeconds(const RunFrames& run) {
  std::map<uint32_t, Sum> times_ms;
  for (const Frame& frame : run.frames) {
    if (!countsForStages(frame, run.shadow)) continue;
    if (counts(frame)) times_ms[secondOf(frame)].add(frame.total_ms);
    SecondSums& second = seconds_[secondOf(frame)];
    second.live.add(frame.live);
    if (!frame.staged) continue;
    second.stages_ms.resize(stages_.size());
    for (size_t i = 0; i < std::min(stages_.size(), frame.stages_ms.size()); ++i) {
      second.stages_ms[i].add(frame.stages_ms[i], frame.ticks);
    }
  }
  for (const auto& [time_s, frames] : times_ms) {
    const double fps = 1e3 / frames.mean();
    if (!std::isfinite(fps)) continue;
    SecondSums& second = seconds_[time_s];
    second.low = second.fps.count == 0 ? fps : std::min(second.low, fps);
    second.high = std::max(second.high, fps);
    second.fps.add(fps);
  }
}

Contender ContenderFigures::finish() const {
  Contender contender;
  contender.name = name_;
  contender.about = about_;
  contender.shadow = shadow_;
  contender.runs = runs_;
  contender.stages = stages_;
  for (const Sum& stage : stages_ms_) contender.stages_ms.push_back(stage.mean());
  for (const Metric& metric : metrics()) {
    const Estimate estimate = bootstrapMean(overRuns(runs_, metric.name));
    if (!std::isnan(estimate.value)) contender.overall[metric.name] = estimate;
  }
  for (const auto& [time_s, sums] : seconds_) {
    if (sums.fps.count == 0) continue;
    Second second{double(time_s), {sums.fps.mean(), sums.low, sums.high}, sums.live.mean(), {}};
    for (const Sum& stage : sums.stages_ms) second.stages_ms.push_back(stage.mean());
    contender.seconds.push_back(std::move(second));
  }
  contender.histogram = histogramOf(frames_ms_);
  contender.percentiles = percentilesOf(frames_ms_);
  for (const auto& [index, bin] : liveBins_) {
    if (bin.ticks_ms.size() < kLeastTicks) continue;
    contender.tickOverLive.push_back({bin.live.mean(), median(doubles(bin.ticks_ms))});
  }
  return contender;
}

SpeedUp speedUpOf(const Contender& first, const Contender& other) {
  const auto ratio = [&](const char* name) {
    return bootstrapRatio(overRuns(other.runs, name), overRuns(first.runs, name));
  };
  return {other.name, ratio("upkeepAndGathering_ms.mean"), ratio("tick_ms.mean"), ratio("frame_ms.mean")};
}

std::vector<Growth> growthOf(std::span<const Case> cases) {
  struct Points {
    std::string contender;
    bool shadow;
    std::vector<double> live, ticks_ms;
  };
  std::vector<Points> all;
  for (const Case& one : cases) {
    for (const Contender& contender : one.contenders) {
      auto points =
          std::find_if(all.begin(), all.end(), [&](const Points& p) { return p.contender == contender.name; });
      if (points == all.end()) points = all.insert(points, {contender.name, true, {}, {}});
      points->shadow = points->shadow && contender.shadow;
      for (const CurvePoint& point : contender.tickOverLive) {
        points->live.push_back(point.x);
        points->ticks_ms.push_back(point.y);
      }
    }
  }
  std::vector<Growth> growth;
  for (const Points& points : all) {
    Growth one{points.contender, fitPower(points.live, points.ticks_ms), ""};
    if (!one.fit) {
      one.why = points.shadow ? "It ran in shadow, which has no ticks of its own."
                              : "Too few numbers of live enemies: a fit takes three, the greatest 1.5 times the least.";
    }
    growth.push_back(std::move(one));
  }
  return growth;
}

}  // namespace gw::profile
