// A picture of lines, areas and text as SVG, in the order in which they are drawn. Lengths are in its own pixels, y
// down.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/profile/report/palette.h"

namespace gw::profile {

struct Point {
  double x, y;
};
struct Box {
  double x, y, width, height;
};
struct Stroke {
  const Colour& colour;
  double width = 1;
  const char* dash = "";
};
struct Font {
  double size = 13;
  const char* anchor = "start";  // "middle", "end"
  const Colour& colour = colour::kInk;
  bool bold = false;
  bool upwards = false;  // turned by 90 degrees
};

class Svg {
 public:
  Svg(double width, double height, std::string_view title, std::string_view description);

  void box(const Box& box, const Colour& fill, double radius = 0, const Colour* edge = nullptr);
  void line(Point from, Point to, const Stroke& stroke);
  void path(std::span<const Point> points, const Stroke& stroke);  // fewer than two: nothing
  void area(std::span<const Point> outline, const Colour& fill, double opacity, bool edged = false);
  // A small shape; six of them differ.
  void marker(Point at, size_t shape, const Colour& colour);
  void text(Point at, std::string_view text, const Font& font = {});

  // Standing alone and inside a page alike.
  std::string whole() const;

 private:
  std::string fill(const Colour& colour);
  std::string stroke(const Stroke& stroke);
  void use(const Colour& colour);

  std::string head_, body_;
  std::vector<const Colour*> used_;
};

// About how wide `text` will be; fonts differ by a few percent.
double widthOf(std::string_view text, double size);
// Shortened so that it fits.
std::string fitted(std::string_view text, double size, double width);

}  // namespace gw::profile
