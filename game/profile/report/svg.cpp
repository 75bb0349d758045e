#include "game/profile/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host/platform/markup_text.h"

namespace gw::profile {

namespace {

constexpr double kWidthPerSize = 0.6;  // of a character of DejaVu Sans, on the mean
constexpr double kPi = 3.14159265358979323846;

// Two decimals, and no more zeros than needed: half of a picture's bytes are numbers.
std::string px(double length) {
  std::string text = fmt::format("{:.2f}", length);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string listed(std::span<const Point> points) {
  std::string list;
  for (const Point& point : points) list += px(point.x) + "," + px(point.y) + " ";
  if (!list.empty()) list.pop_back();
  return list;
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title, std::string_view description) {
  head_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
      "aria-label=\"{2}. {3}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n",
      px(width), px(height), xmlEscaped(title), xmlEscaped(description));
}

void Svg::use(const Colour& colour) {
  if (std::find(used_.begin(), used_.end(), &colour) == used_.end()) used_.push_back(&colour);
}

// The attribute is what programs without CSS see; the class is for dark pages.
std::string Svg::fill(const Colour& colour) {
  use(colour);
  return fmt::format("class=\"gw-f-{}\" fill=\"{}\"", colour.name, colour.light);
}

std::string Svg::stroke(const Stroke& stroke) {
  use(stroke.colour);
  std::string text = fmt::format("class=\"gw-s-{}\" stroke=\"{}\" stroke-width=\"{}\"", stroke.colour.name,
                                 stroke.colour.light, px(stroke.width));
  if (*stroke.dash != '\0') text += fmt::format(" stroke-dasharray=\"{}\"", stroke.dash);
  return text;
}

void Svg::box(const Box& box, const Colour& colour, double radius, const Colour* edge) {
  std::string outline;
  if (edge != nullptr) {
    use(*edge);
    outline = fmt::format(" stroke=\"{}\"", edge->light);
  }
  use(colour);
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{} class=\"gw-f-{}{}{}\" fill=\"{}\"{}/>\n",
                       px(box.x), px(box.y), px(std::max(0.0, box.width)), px(std::max(0.0, box.height)),
                       radius > 0 ? fmt::format(" rx=\"{}\"", px(radius)) : "", colour.name, edge ? " gw-s-" : "",
                       edge ? edge->name : "", colour.light, outline);
}

void Svg::line(Point from, Point to, const Stroke& with) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", px(from.x), px(from.y), px(to.x),
                       px(to.y), stroke(with));
}

void Svg::path(std::span<const Point> points, const Stroke& with) {
  if (points.size() < 2) return;
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", listed(points),
                       stroke(with));
}

void Svg::area(std::span<const Point> outline, const Colour& colour, double opacity, bool edged) {
  if (outline.size() < 3) return;
  use(colour);
  use(colour::kPanel);
  body_ += fmt::format("<polygon points=\"{}\" class=\"gw-f-{}{}\" fill=\"{}\"", listed(outline), colour.name,
                       edged ? " gw-s-panel" : "", colour.light);
  if (opacity < 1) body_ += fmt::format(" fill-opacity=\"{}\"", px(opacity));
  if (edged) body_ += fmt::format(" stroke=\"{}\" stroke-width=\"0.7\"", colour::kPanel.light);
  body_ += "/>\n";
}

void Svg::marker(Point at, size_t shape, const Colour& colour) {
  constexpr double kRadius = 4;
  if (shape % 6 == 0) {
    body_ +=
        fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(at.x), px(at.y), px(kRadius - 0.4), fill(colour));
    return;
  }
  // Corners of a star or polygon: square, triangle, diamond, four-pointed star, triangle that stands on its tip.
  struct Shape {
    int corners;
    double turned, inner;
  };
  constexpr Shape kShapes[] = {{4, kPi / 4, 1}, {3, -kPi / 2, 1}, {4, 0, 1}, {8, 0, 0.4}, {3, kPi / 2, 1}};
  const Shape& as = kShapes[shape % 6 - 1];
  std::vector<Point> corners;
  for (int i = 0; i < as.corners; ++i) {
    const double angle = as.turned + 2 * kPi * i / as.corners;
    const double radius = (kRadius + 0.8) * (i % 2 == 1 ? as.inner : 1);
    corners.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  area(corners, colour, 1);
}

void Svg::text(Point at, std::string_view text, const Font& font) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", px(at.x), px(at.y), px(font.size));
  if (std::string_view(font.anchor) != "start") body_ += fmt::format(" text-anchor=\"{}\"", font.anchor);
  if (font.bold) body_ += " font-weight=\"bold\"";
  if (font.upwards) body_ += fmt::format(" transform=\"rotate(-90 {} {})\"", px(at.x), px(at.y));
  body_ += fmt::format(" {}>{}</text>\n", fill(font.colour), xmlEscaped(text));
}

std::string Svg::whole() const {
  std::string style = "<style>@media screen and (prefers-color-scheme: dark) {";
  for (const Colour* colour : used_) {
    style += fmt::format(".gw-f-{0}{{fill:{1}}}.gw-s-{0}{{stroke:{1}}}", colour->name, colour->dark);
  }
  return head_ + style + "}</style>\n" + body_ + "</svg>\n";
}

double widthOf(std::string_view text, double size) {
  return kWidthPerSize * size * double(lengthOf(text));
}

std::string fitted(std::string_view text, double size, double width) {
  return shortened(text, size_t(std::max(1.0, width / (kWidthPerSize * size))));
}

}  // namespace gw::profile
