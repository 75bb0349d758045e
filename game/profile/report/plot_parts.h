// What the files plots_*.cpp share; plots.cpp puts their pictures together.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "game/profile/report/chart.h"
#include "game/profile/report/plots.h"

namespace gw::profile {

// How contenders look: the same in every picture of a report.
class Styles {
 public:
  explicit Styles(const Report& report);
  size_t of(const std::string& contender) const;

 private:
  std::vector<std::string> names_;
};

// "8,192 enemies asked, 8,190 to 8,192 live": the least of all frames, and the most of all seconds.
std::string askedAndLive(std::span<const Case> cases);

// Without file name and case, which plots.cpp adds.
Plot fpsOverTime(const Case& of, const Setup& setup, const Styles& styles);
Plot frameTimes(const Case& of, const Styles& styles);
Plot percentileCurves(const Case& of, const Styles& styles);
Plot stageBars(const Case& of);
Plot stagesOverTime(const Case& of);
Plot tickOverLive(const Report& report, const Styles& styles);
Plot speedUps(const Report& report);

// Of the live enemies of a contender, for the right axis.
std::vector<CurvePoint> liveCurve(const Contender& of);
Axis liveAxis(const Contender& of);
double lastSecond(const Case& of);

}  // namespace gw::profile
