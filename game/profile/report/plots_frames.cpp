// How long frames took: how many of each length, and what share stays below a length.
#include <algorithm>
#include <cmath>

#include "game/profile/report/plot_parts.h"

namespace gw::profile {

namespace {

// Of 60 and of 30 frames a second.
constexpr struct {
  double ms;
  const char* label;
} kMarks[] = {{1000 / 60.0, "16.7 ms"}, {1000 / 30.0, "33.3 ms"}};

const double kWidth = std::log(1.05);

void takeMarks(Range& range) {
  for (const auto& mark : kMarks) range.take(mark.ms);
}

uint64_t framesOf(const Contender& of) {
  uint64_t frames = 0;
  for (const Bin& bin : of.histogram) frames += bin.frames;
  return frames;
}

// The outline of the bars, in percent of all frames for each 5 % of time: bins of contenders differ in width.
std::vector<CurvePoint> outline(const Contender& of) {
  const double all = double(framesOf(of));
  std::vector<CurvePoint> points;
  for (size_t i = 0; i < of.histogram.size(); ++i) {
    const Bin& bin = of.histogram[i];
    if (bin.frames == 0) continue;
    const double percent = 100 * double(bin.frames) / all * kWidth / std::log(bin.to_ms / bin.from_ms);
    if (i == 0 || of.histogram[i - 1].frames == 0) points.push_back({bin.from_ms, 0});
    points.push_back({bin.from_ms, percent});
    points.push_back({bin.to_ms, percent});
    if (i + 1 < of.histogram.size() && of.histogram[i + 1].frames != 0) continue;
    points.push_back({bin.to_ms, 0});
    points.push_back({kUnknown, kUnknown});  // no line along what is empty
  }
  return points;
}

Plot plotOf(const Words& words) {
  return {.name = "", .caption = words.description, .svg = "", .ofCase = {}};
}

}  // namespace

Plot frameTimes(const Case& of, const Styles& styles) {
  const Words words{"Frame times", askedAndLive({&of, 1}), "How many of the frames of all runs took how long."};
  Plot plot = plotOf(words);
  Range time, percent;
  std::vector<Key> keys;
  for (const Contender& contender : of.contenders) {
    if (framesOf(contender) == 0) continue;
    keys.push_back({Key::Kind::line, styles.of(contender.name), contender.name});
    for (const CurvePoint& point : outline(contender)) {
      time.takePositive(point.x);
      percent.take(point.y);
    }
  }
  if (keys.empty() || time.empty()) {
    plot.svg = emptyPicture(words, "No frame was measured.");
    return plot;
  }
  takeMarks(time);
  Chart chart(words, keys, logarithmicAxis("frame time / ms", time),
              linearAxis("frames per 5 % of time / %", percent.high * 1.02));
  for (const auto& mark : kMarks) chart.markX(mark.ms, mark.label);
  for (const Contender& contender : of.contenders) {
    const std::vector<CurvePoint> top = outline(contender);
    std::vector<CurvePoint> ground = top;
    for (CurvePoint& point : ground) point.y *= 0;
    chart.band(ground, top, lineColour(styles.of(contender.name)), 0.14);
  }
  for (const Contender& contender : of.contenders) chart.line(outline(contender), styles.of(contender.name), true);
  plot.svg = chart.svg();
  return plot;
}

Plot percentileCurves(const Case& of, const Styles& styles) {
  const Words words{"Percentiles of the frame time", askedAndLive({&of, 1}),
                    "The share of frames on the horizontal axis took no longer than the time on the vertical one; each "
                    "step to the right leaves a tenth of the frames out."};
  Plot plot = plotOf(words);
  const Axis nines = ninesAxis("frames that took no longer / %");
  Range time;
  std::vector<Key> keys;
  for (const Contender& contender : of.contenders) {
    if (contender.percentiles.empty()) continue;
    keys.push_back({Key::Kind::line, styles.of(contender.name), contender.name});
    for (const CurvePoint& point : contender.percentiles) {
      if (point.x <= nines.high) time.takePositive(point.y);
    }
  }
  if (time.empty()) {
    plot.svg = emptyPicture(words, "No frame was measured.");
    return plot;
  }
  takeMarks(time);
  Chart chart(words, keys, nines, logarithmicAxis("frame time / ms", time));
  for (const auto& mark : kMarks) chart.markY(mark.ms, mark.label);
  for (const Contender& contender : of.contenders) {
    chart.line(contender.percentiles, styles.of(contender.name), true);
  }
  plot.svg = chart.svg();
  return plot;
}

}  // namespace gw::profile
