// A chart in a panel: title, subtitle, legend and axes around lines, bands and areas.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"
#include "game/profile/report/axis.h"
#include "game/profile/report/svg.h"

namespace gw::profile {

struct Words {
  std::string title;
  std::string subtitle;     // how many enemies there were
  std::string description;  // for those who do not see it
};

// An entry of the legend.
struct Key {
  enum class Kind { line, points, area, live, fit } kind;
  size_t style;  // the contender's or stage's
  std::string label;
};

class Chart {
 public:
  Chart(const Words& words, std::span<const Key> keys, Axis x, Axis y, std::optional<Axis> right = {});

  // Points that have no place on the axes are left out, and part the line.
  void line(std::span<const CurvePoint> points, size_t style, bool marked);
  void points(std::span<const CurvePoint> points, size_t style);
  void fit(std::span<const CurvePoint> points, size_t style);
  void live(std::span<const CurvePoint> points);  // on the right axis
  // Between two lines over the same x.
  void band(std::span<const CurvePoint> low, std::span<const CurvePoint> high, const Colour& colour, double opacity,
            bool edged = false);
  void label(CurvePoint at, std::string_view text, const Colour& colour);  // in the middle of it
  void markX(double x, std::string_view label);
  void markY(double y, std::string_view label);

  static double shareOfWidth(std::string_view label);  // that it takes of the narrowest plot
  double heightOf(double y) const;                     // in pixels, of a distance from 0
  std::string svg() const { return svg_.whole(); }

 private:
  Point at(const Axis& y, CurvePoint point) const;
  // Calls draw(places) for every part without a hole.
  template <class Draw>
  void eachPart(const Axis& y, std::span<const CurvePoint> points, const Draw& draw) const;
  void drawAxes();

  Box plot_;
  Axis x_, y_;
  std::optional<Axis> right_;
  Svg svg_;
};

// What all pictures have: a panel with words above, and how far down they reach.
Svg panel(const Words& words, double height);
double legendHeight(std::span<const Key> keys);
void legend(Svg& svg, std::span<const Key> keys);

inline constexpr double kPictureWidth = 960, kHeaderHeight = 66, kPadding = 24;

// Of a chart that nothing was measured for.
std::string emptyPicture(const Words& words, std::string_view sentence);

}  // namespace gw::profile
