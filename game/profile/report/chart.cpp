#include "game/profile/report/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gw::profile {

namespace {

constexpr double kPlotHeight = 350, kLeft = 84, kRightOfAxis = 84, kBelow = 58;
constexpr double kTitleSize = 19, kSmall = 12.5, kAreaLabelSize = 11.5;
constexpr double kKeyHeight = 22, kKeySample = 34, kKeyGap = 22;
constexpr double kMarkerEvery_px = 70;
constexpr Stroke kLiveStroke{colour::kFaint, 1.2, "1.5 2.5"};

// Where each entry of the legend begins; entries wrap.
std::vector<Point> keyPlaces(std::span<const Key> keys) {
  std::vector<Point> places;
  Point at{kPadding, kHeaderHeight};
  for (const Key& key : keys) {
    const double width = kKeySample + widthOf(key.label, kSmall) + kKeyGap;
    if (at.x > kPadding && at.x + width > kPictureWidth - kPadding) at = {kPadding, at.y + kKeyHeight};
    places.push_back(at);
    at.x += width;
  }
  return places;
}

void keySample(Svg& svg, const Key& key, Point at) {
  const Point middle{at.x + 13, at.y + kKeyHeight / 2}, from{at.x, middle.y}, to{at.x + 26, middle.y};
  switch (key.kind) {
    case Key::Kind::line:
      svg.line(from, to, {lineColour(key.style), 2.2, dashOf(key.style)});
      svg.marker(middle, key.style, lineColour(key.style));
      break;
    case Key::Kind::points:
      svg.marker(middle, key.style, lineColour(key.style));
      break;
    case Key::Kind::fit:
      svg.line(from, to, {lineColour(key.style), 1.4, dashOf(key.style)});
      svg.marker(middle, key.style, lineColour(key.style));
      break;
    case Key::Kind::live:
      svg.line(from, to, kLiveStroke);
      break;
    case Key::Kind::area:
      svg.box({at.x + 4, at.y + 4, 18, 14}, areaColour(key.style), 2);
      break;
  }
}

Box plotBelow(std::span<const Key> keys, bool right) {
  const double top = kHeaderHeight + legendHeight(keys) + 12;
  return {kLeft, top, kPictureWidth - kLeft - (right ? kRightOfAxis : kPadding + 8), kPlotHeight};
}

}  // namespace

Svg panel(const Words& words, double height) {
  Svg svg(kPictureWidth, height, words.title, words.subtitle + ". " + words.description);
  svg.box({0.5, 0.5, kPictureWidth - 1, height - 1}, colour::kPanel, 8, &colour::kEdge);
  const double room = kPictureWidth - 2 * kPadding;
  svg.text({kPadding, 34}, fitted(words.title, kTitleSize * 1.1, room), {.size = kTitleSize, .bold = true});
  svg.text({kPadding, 56}, fitted(words.subtitle, 13, room), {.size = 13, .colour = colour::kFaint});
  return svg;
}

double legendHeight(std::span<const Key> keys) {
  return keys.empty() ? 0 : keyPlaces(keys).back().y - kHeaderHeight + kKeyHeight;
}

void legend(Svg& svg, std::span<const Key> keys) {
  const std::vector<Point> places = keyPlaces(keys);
  for (size_t i = 0; i < keys.size(); ++i) {
    keySample(svg, keys[i], places[i]);
    const double room = kPictureWidth - kPadding - places[i].x - kKeySample;
    svg.text({places[i].x + kKeySample, places[i].y + 15.5}, fitted(keys[i].label, kSmall, room), {.size = kSmall});
  }
}

Chart::Chart(const Words& words, std::span<const Key> keys, Axis x, Axis y, std::optional<Axis> right)
    : plot_(plotBelow(keys, right.has_value())),
      x_(std::move(x)),
      y_(std::move(y)),
      right_(std::move(right)),
      svg_(panel(words, plot_.y + plot_.height + kBelow)) {
  legend(svg_, keys);
  drawAxes();
}

void Chart::drawAxes() {
  const double bottom = plot_.y + plot_.height, end = plot_.x + plot_.width;
  for (const Tick& tick : y_.ticks) {
    const double y = bottom - plot_.height * y_.share(tick.value);
    svg_.line({plot_.x, y}, {end, y}, {colour::kGrid});
    svg_.text({plot_.x - 8, y + 4.5}, tick.label, {.size = kSmall, .anchor = "end", .colour = colour::kFaint});
  }
  for (const Tick& tick : x_.ticks) {
    const double x = plot_.x + plot_.width * x_.share(tick.value);
    svg_.line({x, plot_.y}, {x, bottom}, {colour::kGrid});
    svg_.text({x, bottom + 18}, tick.label, {.size = kSmall, .anchor = "middle", .colour = colour::kFaint});
  }
  svg_.line({plot_.x, bottom}, {end, bottom}, {colour::kFaint, 1.2});
  svg_.line({plot_.x, plot_.y}, {plot_.x, bottom}, {colour::kFaint, 1.2});
  svg_.text({plot_.x + plot_.width / 2, bottom + 42}, x_.label, {.anchor = "middle"});
  const double middle = plot_.y + plot_.height / 2;
  svg_.text({24, middle}, y_.label, {.anchor = "middle", .upwards = true});
  if (!right_) return;
  svg_.line({end, plot_.y}, {end, bottom}, {colour::kFaint, 1.2});
  for (const Tick& tick : right_->ticks) {
    const double y = bottom - plot_.height * right_->share(tick.value);
    svg_.line({end, y}, {end + 5, y}, {colour::kFaint});
    svg_.text({end + 9, y + 4.5}, tick.label, {.size = kSmall, .colour = colour::kFaint});
  }
  svg_.text({kPictureWidth - 12, middle}, right_->label,
            {.anchor = "middle", .colour = colour::kFaint, .upwards = true});
}

Point Chart::at(const Axis& y, CurvePoint point) const {
  return {plot_.x + plot_.width * x_.share(point.x), plot_.y + plot_.height * (1 - y.share(point.y))};
}

template <class Draw>
void Chart::eachPart(const Axis& y, std::span<const CurvePoint> points, const Draw& draw) const {
  constexpr double kEdge = 1e-6;
  std::vector<Point> part;
  const auto end = [&] {
    if (!part.empty()) draw(std::as_const(part));
    part.clear();
  };
  for (const CurvePoint& point : points) {
    const double across = x_.share(point.x), up = y.share(point.y);
    const bool inside = across >= -kEdge && across <= 1 + kEdge && up >= -kEdge && up <= 1 + kEdge;  // false for NaN
    if (inside) {
      part.push_back(at(y, point));
    } else {
      end();
    }
  }
  end();
}

void Chart::line(std::span<const CurvePoint> points, size_t style, bool marked) {
  eachPart(y_, points, [&](const std::vector<Point>& part) {
    svg_.path(part, {lineColour(style), 2.2, dashOf(style)});
    if (part.size() == 1) svg_.marker(part[0], style, lineColour(style));
    if (!marked) return;
    double next = part[0].x + kMarkerEvery_px / 6 * double(style % 6 + 1);  // lines that lie on each other show both
    for (const Point& point : part) {
      if (point.x < next) continue;
      svg_.marker(point, style, lineColour(style));
      next = point.x + kMarkerEvery_px;
    }
  });
}

void Chart::points(std::span<const CurvePoint> points, size_t style) {
  eachPart(y_, points, [&](const std::vector<Point>& part) {
    for (const Point& point : part) svg_.marker(point, style, lineColour(style));
  });
}

void Chart::fit(std::span<const CurvePoint> points, size_t style) {
  eachPart(y_, points, [&](const std::vector<Point>& part) {
    svg_.path(part, {lineColour(style), 1.4, dashOf(style)});
  });
}

void Chart::live(std::span<const CurvePoint> points) {
  if (right_) eachPart(*right_, points, [&](const std::vector<Point>& part) { svg_.path(part, kLiveStroke); });
}

void Chart::band(std::span<const CurvePoint> low, std::span<const CurvePoint> high, const Colour& colour,
                 double opacity, bool edged) {
  std::vector<Point> below, above;
  const auto end = [&] {
    above.insert(above.end(), below.rbegin(), below.rend());
    svg_.area(above, colour, opacity, edged);
    below.clear();
    above.clear();
  };
  for (size_t i = 0; i < low.size(); ++i) {
    const Point bottom = at(y_, low[i]), top = at(y_, high[i]);
    if (std::isfinite(bottom.x) && std::isfinite(bottom.y) && std::isfinite(top.x) && std::isfinite(top.y)) {
      below.push_back(bottom);
      above.push_back(top);
    } else {
      end();
    }
  }
  end();
}

void Chart::label(CurvePoint point, std::string_view text, const Colour& colour) {
  const Point place = at(y_, point);
  svg_.text({place.x, place.y + 4}, text, {.size = kAreaLabelSize, .anchor = "middle", .colour = colour});
}

void Chart::markX(double x, std::string_view label) {
  const double place = plot_.x + plot_.width * x_.share(x);
  svg_.line({place, plot_.y}, {place, plot_.y + plot_.height}, {colour::kReference, 1.2, "6 3"});
  svg_.text({place + 5, plot_.y + 13}, label, {.size = 11.5, .colour = colour::kReference});
}

void Chart::markY(double y, std::string_view label) {
  const double place = plot_.y + plot_.height * (1 - y_.share(y));
  svg_.line({plot_.x, place}, {plot_.x + plot_.width, place}, {colour::kReference, 1.2, "6 3"});
  svg_.text({plot_.x + 7, place - 5}, label, {.size = 11.5, .colour = colour::kReference});
}

double Chart::shareOfWidth(std::string_view label) {
  return widthOf(label, kAreaLabelSize) / (kPictureWidth - kLeft - kRightOfAxis);
}

double Chart::heightOf(double y) const {
  return plot_.height * (y_.share(y) - y_.share(0));
}

std::string emptyPicture(const Words& words, std::string_view sentence) {
  Svg svg = panel(words, 200);
  svg.text({kPictureWidth / 2, 125}, fitted(sentence, 15, kPictureWidth - 2 * kPadding),
           {.size = 15, .anchor = "middle", .colour = colour::kFaint});
  return svg.whole();
}

}  // namespace gw::profile
