// Frames per second over time.
#include <algorithm>
#include <cmath>

#include "game/profile/report/plot_parts.h"

namespace gw::profile {

namespace {

constexpr double kBandOpacity = 0.16;

std::vector<CurvePoint> curve(const Contender& of, double Estimate::*member) {
  std::vector<CurvePoint> points;
  for (const Second& second : of.seconds) points.push_back({second.time_s, second.fps.*member});
  return points;
}

}  // namespace

Plot fpsOverTime(const Case& of, const Setup& setup, const Styles& styles) {
  const bool ticksOnly = setup.drawn.starts_with("nothing");
  Words words{"Frames per second over time", askedAndLive({&of, 1}), ""};
  words.description = ticksOnly
                          ? "The mean of all runs for each second of game time, in a band from the slowest to the "
                            "fastest run; nothing was drawn, so a frame is a tick."
                          : "The mean of all runs for each second of game time, in a band from the slowest to "
                            "the fastest run.";
  Plot plot{.name = "", .caption = words.description, .svg = "", .ofCase = {}};

  Range fps;
  std::vector<Key> keys;
  const Contender* first = nullptr;
  for (const Contender& contender : of.contenders) {
    Range own;
    for (const Second& second : contender.seconds) {
      for (const double value : {second.fps.value, second.fps.low, second.fps.high}) own.take(value);
    }
    if (own.empty()) continue;
    fps.take(own.high);
    keys.push_back({Key::Kind::line, styles.of(contender.name), contender.name});
    if (first == nullptr) first = &contender;
  }
  if (first == nullptr) {
    plot.svg = emptyPicture(words, "No second of frames was measured.");
    return plot;
  }
  keys.push_back({Key::Kind::live, 0, "live enemies (right axis)"});

  Chart chart(words, keys, linearAxis("game time / s", lastSecond(of), true),
              linearAxis(ticksOnly ? "frames per second (a frame is a tick)" : "frames per second", fps.high * 1.02),
              liveAxis(*first));
  chart.live(liveCurve(*first));
  for (const Contender& contender : of.contenders) {
    chart.band(curve(contender, &Estimate::low), curve(contender, &Estimate::high),
               lineColour(styles.of(contender.name)), kBandOpacity);
  }
  for (const Contender& contender : of.contenders) {
    chart.line(curve(contender, &Estimate::value), styles.of(contender.name), true);
  }
  plot.svg = chart.svg();
  return plot;
}

}  // namespace gw::profile
