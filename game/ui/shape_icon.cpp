#include "game/ui/shape_icon.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace gw {

namespace {

constexpr float kLine = 1.6f;

struct Corner {
  float x, y;  // y up, within the unit circle
};

class Icon {
 public:
  Icon(Canvas& canvas, float x, float y, float radius, Rgba colour)
      : canvas_(canvas), x_(x), y_(y), radius_(radius), colour_(colour) {}

  void closed(std::initializer_list<Corner> corners) const {
    const Corner* last = corners.end() - 1;
    for (const Corner& corner : corners) {
      line(*last, corner);
      last = &corner;
    }
  }
  // A star's inner corners lie on `inner`; 1 gives a plain polygon.
  void star(int corners, float outer, float inner, float turned) const {
    for (int i = 0; i < corners; ++i)
      line(at(i, corners, outer, inner, turned), at(i + 1, corners, outer, inner, turned));
  }
  void square(float left, float top, float side) const {
    canvas_.rectangle(x_ + left * radius_, y_ + top * radius_, side * radius_, side * radius_, colour_);
  }

 private:
  static Corner at(int i, int corners, float outer, float inner, float turned) {
    const float angle = turned + float(2 * std::numbers::pi) * float(i) / float(corners);
    const float reach = i % 2 == 0 ? outer : inner;
    return {reach * std::cos(angle), reach * std::sin(angle)};
  }
  void line(Corner a, Corner b) const {
    canvas_.line(x_ + a.x * radius_, y_ - a.y * radius_, x_ + b.x * radius_, y_ - b.y * radius_, kLine, colour_);
  }

  Canvas& canvas_;
  float x_, y_, radius_;
  Rgba colour_;
};

}  // namespace

void drawShapeIcon(Canvas& canvas, Shape shape, float x, float y, float radius, Rgba colour) {
  const Icon icon(canvas, x, y, radius, colour);
  switch (shape) {
    case Shape::triangle:
      return icon.closed({{1, 0}, {-.7f, .85f}, {-.7f, -.85f}});
    case Shape::square:
      return icon.closed({{.8f, .8f}, {-.8f, .8f}, {-.8f, -.8f}, {.8f, -.8f}});
    case Shape::hexagon:
      return icon.star(6, 1, 1, 0);
    case Shape::dart:
      return icon.closed({{1, 0}, {-.9f, .7f}, {-.4f, 0}, {-.9f, -.7f}});
    case Shape::checkered:
      icon.closed({{.8f, .8f}, {-.8f, .8f}, {-.8f, -.8f}, {.8f, -.8f}});
      icon.square(-.8f, -.8f, .8f);
      return icon.square(0, 0, .8f);
    case Shape::star:
      return icon.star(8, 1, .42f, 0);
    case Shape::doubleRing:
      icon.star(16, 1, 1, 0);
      return icon.star(10, .5f, .5f, 0);
    default:
      return icon.closed({{.8f, 0}, {0, .8f}, {-.8f, 0}, {0, -.8f}});
  }
}

}  // namespace gw
