// Contenders against each other: how their ticks grow with enemies, and how many times faster the first one is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/profile/report/bars.h"
#include "game/profile/report/number_text.h"
#include "game/profile/report/plot_parts.h"

namespace gw::profile {

namespace {

std::vector<CurvePoint> pointsOf(const Report& report, const std::string& contender) {
  std::vector<CurvePoint> points;
  for (const Case& of : report.cases) {
    for (const Contender& one : of.contenders) {
      if (one.name == contender) points.insert(points.end(), one.tickOverLive.begin(), one.tickOverLive.end());
    }
  }
  std::erase_if(points, [](const CurvePoint& point) { return !(point.x > 0 && point.y > 0); });
  std::stable_sort(points.begin(), points.end(), [](CurvePoint a, CurvePoint b) { return a.x < b.x; });
  return points;
}

// A straight line between logarithms.
std::vector<CurvePoint> fitted(const PowerFit& fit, const std::vector<CurvePoint>& points) {
  const auto y = [&](double x) { return fit.factor * std::pow(x, fit.exponent); };
  return {{points.front().x, y(points.front().x)}, {points.back().x, y(points.back().x)}};
}

std::string growthText(const Growth& growth) {
  if (!growth.fit) return growth.contender + ": no fit" + (growth.why.empty() ? "" : ". " + growth.why);
  return fmt::format("{}: live to the power {:.2f}, R² {}", growth.contender, growth.fit->exponent,
                     figureText(growth.fit->r2));
}

struct Kind {
  const char* name;
  Estimate SpeedUp::*member;
  size_t style;
};
constexpr Kind kKinds[] = {{"upkeep and gathering", &SpeedUp::upkeepAndGathering, 1},
                           {"tick", &SpeedUp::tick, 3},
                           {"frame", &SpeedUp::frame, 5}};

// "ngrid" where all cases begin with it.
std::string firstName(const Report& report) {
  std::string name;
  for (const Case& of : report.cases) {
    if (of.contenders.empty()) continue;
    if (!name.empty() && name != of.contenders[0].name) return "the first";
    name = of.contenders[0].name;
  }
  return name.empty() ? "the first" : name;
}

std::vector<BarRow> speedUpRows(const Report& report) {
  std::vector<BarRow> rows;
  for (const Case& of : report.cases) {
    const std::string first = of.contenders.empty() ? "" : of.contenders[0].name;
    for (const SpeedUp& speedUp : of.speedUps) {
      const std::string group = fmt::format("{}: {} against {}", askedAndLive({&of, 1}), first, speedUp.contender);
      for (const Kind& kind : kKinds) {
        const Estimate& ratio = speedUp.*kind.member;
        if (!std::isfinite(ratio.value)) continue;
        rows.push_back({group, kind.name, {{ratio.value, kind.style, ""}}, ratio, estimateText(ratio)});
      }
    }
  }
  return rows;
}

}  // namespace

Plot tickOverLive(const Report& report, const Styles& styles) {
  const Words words{"Time of a tick over live enemies", askedAndLive(report.cases),
                    "Medians of the time of a tick at so many live enemies, both axes logarithmic, with the power that "
                    "fits them best."};
  Plot plot{.name = "", .caption = words.description, .svg = "", .ofCase = {}};
  Range live, time;
  std::vector<Key> keys;
  for (const Growth& growth : report.growth) {
    const std::vector<CurvePoint> points = pointsOf(report, growth.contender);
    if (points.empty()) continue;
    keys.push_back({growth.fit ? Key::Kind::fit : Key::Kind::points, styles.of(growth.contender), growthText(growth)});
    for (const CurvePoint& point : points) {
      live.takePositive(point.x);
      time.takePositive(point.y);
    }
    if (!growth.fit) continue;
    for (const CurvePoint& point : fitted(*growth.fit, points)) time.takePositive(point.y);
  }
  if (live.empty() || time.empty()) {
    plot.svg = emptyPicture(words, "No tick was measured.");
    return plot;
  }
  Chart chart(words, keys, logarithmicAxis("live enemies", live), logarithmicAxis("time of a tick / ms", time));
  for (const Growth& growth : report.growth) {
    const std::vector<CurvePoint> points = pointsOf(report, growth.contender);
    if (points.empty()) continue;
    if (growth.fit) chart.fit(fitted(*growth.fit, points), styles.of(growth.contender));
    chart.points(points, styles.of(growth.contender));
  }
  plot.svg = chart.svg();
  return plot;
}

Plot speedUps(const Report& report) {
  const std::string first = firstName(report);
  const Words words{"How many times faster " + first + " is", askedAndLive(report.cases),
                    "The time of the other contender over that of " + first +
                        ", with the interval that holds the true ratio with 95 %; right of 1 " + first + " is faster."};
  Plot plot{.name = "", .caption = words.description, .svg = "", .ofCase = {}};
  const std::vector<BarRow> rows = speedUpRows(report);
  if (rows.empty()) {
    plot.svg = emptyPicture(words, "There was nothing to compare with.");
    return plot;
  }
  Range ratios;
  ratios.take(1);
  for (const BarRow& row : rows) {
    for (const double value : {row.interval->value, row.interval->low, row.interval->high}) ratios.takePositive(value);
  }
  // Bars of 1.1 and of 50 are both to be read.
  const bool logarithmic = ratios.high > 8;
  const std::string label = "times as long as " + first;
  const Axis axis = logarithmic ? logarithmicAxis(label, ratios) : linearAxis(label, ratios.high * 1.02);
  std::vector<Key> keys;
  for (const Kind& kind : kKinds) {
    if (std::any_of(rows.begin(), rows.end(), [&](const BarRow& row) { return row.label == kind.name; })) {
      keys.push_back({Key::Kind::area, kind.style, kind.name});
    }
  }
  plot.svg = barPicture(words, keys, axis, rows, logarithmic ? 1 : 0, 1);
  return plot;
}

}  // namespace gw::profile
