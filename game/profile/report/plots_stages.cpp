// What the stages of a tick cost: by contender, and over time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "game/profile/report/bars.h"
#include "game/profile/report/number_text.h"
#include "game/profile/report/plot_parts.h"

namespace gw::profile {

namespace {

constexpr double kReadableRatio = 6;  // of the longest bar to the shortest

// The stages that a picture shows by name, in the order of the tick. When there are more than colours, the cheapest
// share the last colour.
class ShownStages {
 public:
  explicit ShownStages(std::span<const Contender> contenders) {
    std::vector<double> sums;
    for (const Contender& contender : contenders) {
      for (size_t i = 0; i < std::min(contender.stages.size(), contender.stages_ms.size()); ++i) {
        const size_t at = indexOf(contender.stages[i]);
        if (at == names_.size()) {
          names_.push_back(contender.stages[i]);
          sums.push_back(0);
        }
        if (std::isfinite(contender.stages_ms[i])) sums[at] += contender.stages_ms[i];
      }
    }
    if (names_.size() <= kAreaColours) return;
    std::vector<double> sorted = sums;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    const double least = sorted[kAreaColours - 2];
    std::vector<std::string> kept;
    for (size_t i = 0; i < names_.size(); ++i) {
      if (sums[i] >= least && kept.size() + 1 < kAreaColours) kept.push_back(names_[i]);
    }
    names_ = std::move(kept);
    other_ = true;
  }

  size_t size() const { return names_.size() + other_; }
  std::string name(size_t style) const { return style < names_.size() ? names_[style] : "others"; }

  // What each costs; `stages` names `values_ms`.
  std::vector<double> sums(const std::vector<std::string>& stages, const std::vector<double>& values_ms) const {
    std::vector<double> sums(size(), 0.0);
    for (size_t i = 0; i < std::min(stages.size(), values_ms.size()); ++i) {
      const size_t at = std::min(indexOf(stages[i]), sums.size() - 1);
      if (!sums.empty() && std::isfinite(values_ms[i])) sums[at] += values_ms[i];
    }
    return sums;
  }

 private:
  size_t indexOf(const std::string& name) const {
    return size_t(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  std::vector<std::string> names_;
  bool other_ = false;
};

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<Key> keysOf(const ShownStages& stages) {
  std::vector<Key> keys;
  for (size_t i = 0; i < stages.size(); ++i) keys.push_back({Key::Kind::area, i, stages.name(i)});
  return keys;
}

// Names stages where there is most room for the name, and none where there is too little.
void labelAreas(Chart& chart, const ShownStages& stages, const std::vector<std::vector<CurvePoint>>& lines) {
  constexpr double kLeast_px = 15;
  const size_t points = lines[0].size();
  for (size_t style = 0; style < stages.size(); ++style) {
    const std::string name = stages.name(style);
    const auto reach = size_t(double(points) * Chart::shareOfWidth(name) / 2) + 1;
    double best = 0;
    CurvePoint at{};
    for (size_t i = reach; i + reach < points; ++i) {
      double low = 0, high = std::numeric_limits<double>::infinity();  // free all along the name
      for (size_t j = i - reach; j <= i + reach; ++j) {
        low = std::max(low, lines[style][j].y);
        high = std::min(high, lines[style + 1][j].y);
      }
      if (high - low <= 1.05 * best) continue;  // the first of those that are alike, lest names jump about
      best = high - low;
      at = {lines[style][i].x, (low + high) / 2};
    }
    if (chart.heightOf(best) >= kLeast_px) chart.label(at, name, inkOnArea(style));
  }
}

}  // namespace

Plot stageBars(const Case& of) {
  const Words words{"Stages of a tick", askedAndLive({&of, 1}),
                    "What each stage of a tick costs on the mean, one bar for each contender."};
  Plot plot{.name = "", .caption = words.description, .svg = "", .ofCase = {}};
  const ShownStages stages(of.contenders);
  std::vector<std::vector<double>> bars;
  std::vector<std::string> names;
  Range all;
  for (const Contender& contender : of.contenders) {
    if (contender.stages.empty() || contender.stages_ms.empty()) continue;
    bars.push_back(stages.sums(contender.stages, contender.stages_ms));
    names.push_back(contender.name);
    all.takePositive(sumOf(bars.back()));
  }
  if (all.empty()) {
    plot.svg = emptyPicture(words, "No tick was timed stage by stage.");
    return plot;
  }
  const bool shares = all.high > kReadableRatio * all.low;
  if (shares) plot.caption += " The bars are of one length, since the shortest would be too short to read.";
  std::vector<BarRow> rows;
  for (size_t bar = 0; bar < bars.size(); ++bar) {
    const double sum = sumOf(bars[bar]);
    BarRow row{.group = "", .label = names[bar], .segments = {}, .interval = {}, .end = figureText(sum) + " ms"};
    for (size_t i = 0; i < stages.size(); ++i) {
      row.segments.push_back({shares && sum > 0 ? 100 * bars[bar][i] / sum : bars[bar][i], i, stages.name(i)});
    }
    rows.push_back(std::move(row));
  }
  plot.svg = barPicture(words, keysOf(stages),
                        shares ? linearAxis("share of the tick / %", 100) : linearAxis("time of a tick / ms", all.high),
                        rows, 0);
  return plot;
}

Plot stagesOverTime(const Case& of) {
  Words words{"Stages of a tick over time", askedAndLive({&of, 1}), ""};
  const auto timed = std::find_if(of.contenders.begin(), of.contenders.end(), [](const Contender& contender) {
    return std::any_of(contender.seconds.begin(), contender.seconds.end(),
                       [](const Second& second) { return !second.stages_ms.empty(); });
  });
  const bool none = timed == of.contenders.end();
  words.description = "What each stage of a tick costs in each second of game time" +
                      (none ? "." : ", on the mean of the runs of " + timed->name + ".");
  if (!none) words.title += ": " + timed->name;
  Plot plot{.name = "", .caption = words.description, .svg = "", .ofCase = {}};
  const ShownStages stages(none ? std::span<const Contender>() : std::span(&*timed, 1));
  if (none || stages.size() == 0) {
    plot.svg = emptyPicture(words, "No tick was timed stage by stage.");
    return plot;
  }

  std::vector<std::vector<CurvePoint>> lines(stages.size() + 1);  // each the sum of those below
  double highest = 0;
  for (const Second& second : timed->seconds) {
    if (second.stages_ms.empty()) continue;
    double sum = 0;
    lines[0].push_back({second.time_s, 0});
    const std::vector<double> sums = stages.sums(timed->stages, second.stages_ms);
    for (size_t i = 0; i < sums.size(); ++i) lines[i + 1].push_back({second.time_s, sum += sums[i]});
    highest = std::max(highest, sum);
  }
  std::vector<Key> keys = keysOf(stages);
  keys.push_back({Key::Kind::live, 0, "live enemies (right axis)"});
  Chart chart(words, keys, linearAxis("game time / s", lastSecond(of), true),
              linearAxis("time of a tick / ms", highest * 1.05), liveAxis(*timed));
  for (size_t i = 0; i < stages.size(); ++i) chart.band(lines[i], lines[i + 1], areaColour(i), 1, true);
  labelAreas(chart, stages, lines);
  chart.live(liveCurve(*timed));
  plot.svg = chart.svg();
  return plot;
}

}  // namespace gw::profile
