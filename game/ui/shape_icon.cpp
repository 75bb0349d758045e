#include "game/ui/shape_icon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/sprite_shapes.h"

namespace gw {

namespace {

constexpr float kLine = 1.6f;
constexpr float kLargest = 1.13f;  // of the circle through the furthest corners, in units of the icon's radius

// The corners of a ring that looks round at the size of an icon.
std::vector<ShapeCorner> ring(float radius) {
  const int corners = radius > 0.75f ? 16 : 10;
  std::vector<ShapeCorner> outline;
  for (int i = 0; i < corners; ++i) {
    const float angle = float(2 * std::numbers::pi) * float(i) / float(corners);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

// Appends the mirror image, so that the outline goes on where it ended.
template <class Mirror>
void unfold(std::vector<ShapeCorner>& outline, const Mirror& mirror) {
  for (size_t i = outline.size(); i-- > 0;) outline.push_back(mirror(outline[i]));
}

std::vector<ShapeCorner> outlineOf(const SpriteShape& shape) {
  if (shape.cornerCount == 0) return ring(1);
  std::vector<ShapeCorner> outline(shape.corners, shape.corners + shape.cornerCount);
  if (shape.fold == Fold::diagonal) unfold(outline, [](ShapeCorner c) { return ShapeCorner{c.y, c.x}; });
  if (shape.fold != Fold::along) unfold(outline, [](ShapeCorner c) { return ShapeCorner{-c.x, c.y}; });
  unfold(outline, [](ShapeCorner c) { return ShapeCorner{c.x, -c.y}; });
  return outline;
}

class Icon {
 public:
  Icon(Canvas& canvas, float x, float y, float radius, Rgba colour)
      : canvas_(canvas), x_(x), y_(y), radius_(radius), colour_(colour) {}

  void closed(const std::vector<ShapeCorner>& corners) const {
    ShapeCorner last = corners.back();
    for (const ShapeCorner& corner : corners) {
      if (corner.x != last.x || corner.y != last.y) line(last, corner);
      last = corner;
    }
  }
  // Filled, from its lower left corner.
  void square(float left, float bottom, float side) const {
    canvas_.rectangle(x_ + left * radius_, y_ - (bottom + side) * radius_, side * radius_, side * radius_, colour_);
  }

 private:
  void line(ShapeCorner a, ShapeCorner b) const {
    canvas_.line(x_ + a.x * radius_, y_ - a.y * radius_, x_ + b.x * radius_, y_ - b.y * radius_, kLine, colour_);
  }

  Canvas& canvas_;
  float x_, y_, radius_;
  Rgba colour_;
};

}  // namespace

void drawShapeIcon(Canvas& canvas, Shape shape, float x, float y, float radius, Rgba colour) {
  const SpriteShape& row = kSpriteShapes[std::min(uint32_t(shape), kShapes - 1)];
  const Icon icon(canvas, x, y, radius / std::max(row.radius / kLargest, 1.0f), colour);
  icon.closed(outlineOf(row));
  if (row.innerRing > 0) icon.closed(ring(row.innerRing));
  if (row.chequered) {
    icon.square(0, 0, 1);
    icon.square(-1, -1, 1);
  }
}

}  // namespace gw
