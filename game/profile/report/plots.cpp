#include "game/profile/report/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/profile/report/number_text.h"
#include "game/profile/report/plot_parts.h"

namespace gw::profile {

namespace {

std::string spanText(const Range& range) {
  const std::string low = wholeText(range.low), high = wholeText(range.high);
  return low == high ? low : low + " to " + high;
}

// Two cases of the same size are told apart by a number.
std::string caseName(const Report& report, size_t at) {
  size_t before = 0;
  for (size_t i = 0; i < at; ++i) before += report.cases[i].enemies == report.cases[at].enemies;
  const std::string name = std::to_string(report.cases[at].enemies);
  return before == 0 ? name : fmt::format("{}_{}", name, before + 1);
}

}  // namespace

Styles::Styles(const Report& report) {
  for (const Case& of : report.cases) {
    for (const Contender& contender : of.contenders) {
      if (std::find(names_.begin(), names_.end(), contender.name) == names_.end()) names_.push_back(contender.name);
    }
  }
}

size_t Styles::of(const std::string& contender) const {
  return size_t(std::find(names_.begin(), names_.end(), contender) - names_.begin());
}

std::string askedAndLive(std::span<const Case> cases) {
  Range asked, live;
  for (const Case& of : cases) {
    asked.take(of.enemies);
    for (const Contender& contender : of.contenders) {
      for (const MetricValues& run : contender.runs) {
        if (const auto least = run.find("liveEntities.least"); least != run.end()) live.take(least->second);
      }
      for (const Second& second : contender.seconds) live.take(second.live);
    }
  }
  if (asked.empty()) return "no enemies asked";
  const std::string text = spanText(asked) + (asked.high == 1 ? " enemy" : " enemies") + " asked, ";
  return text + (live.empty() ? "live ones not counted" : spanText(live) + " live");
}

std::vector<CurvePoint> liveCurve(const Contender& of) {
  std::vector<CurvePoint> curve;
  for (const Second& second : of.seconds) curve.push_back({second.time_s, second.live});
  return curve;
}

Axis liveAxis(const Contender& of) {
  Range live;
  for (const Second& second : of.seconds) live.take(second.live);
  return linearAxis("live enemies", live.empty() ? 1 : live.high * 1.02);
}

double lastSecond(const Case& of) {
  Range time;
  for (const Contender& contender : of.contenders) {
    for (const Second& second : contender.seconds) time.take(second.time_s);
  }
  return time.empty() ? 1 : time.high;
}

std::vector<Plot> plotsOf(const Report& report) {
  const Styles styles(report);
  std::vector<Plot> plots;
  const auto add = [&](Plot plot, std::string name, std::optional<size_t> ofCase = {}) {
    plot.name = std::move(name);
    plot.ofCase = ofCase;
    plots.push_back(std::move(plot));
  };
  add(speedUps(report), "speed_ups");
  add(tickOverLive(report, styles), "tick_over_live");
  for (size_t i = 0; i < report.cases.size(); ++i) {
    const Case& of = report.cases[i];
    const std::string name = caseName(report, i);
    add(fpsOverTime(of, report.setup, styles), "fps_over_time_" + name, i);
    add(frameTimes(of, styles), "frame_times_" + name, i);
    add(percentileCurves(of, styles), "percentiles_" + name, i);
    add(stageBars(of), "stages_" + name, i);
    add(stagesOverTime(of), "stages_over_time_" + name, i);
  }
  return plots;
}

}  // namespace gw::profile
