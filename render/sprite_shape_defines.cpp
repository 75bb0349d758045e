#include "render/sprite_shape_defines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "render/sprite_shapes.h"

namespace gw {
namespace {

constexpr uint32_t kMostSides = 3;

// With all digits, so that the shader computes with the same float, and with a point in every locale.
std::string text(float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, double(value), std::chars_format::general, 9).ptr;
  std::string number(digits, end);
  if (number.find_first_of(".e") == std::string::npos) number += ".0";
  return number;
}

template <class... Floats>
std::string vec4(Floats... values) {
  std::string list;
  ((list += (list.empty() ? "vec4(" : ",") + text(values)), ...);
  return list + ")";
}

// From one corner to the next; what is left of the sides is so far away that everything is inside.
std::string sidesOf(const SpriteShape& shape) {
  std::string sides;
  for (uint32_t side = 0; side < kMostSides; ++side) {
    if (side > 0) sides += ",";
    if (side + 1 < shape.cornerCount) {
      const ShapeCorner a = shape.corners[side], b = shape.corners[side + 1];
      sides += "SIDE(" + text(a.x) + "," + text(a.y) + "," + text(b.x) + "," + text(b.y) + ")";
    } else {
      sides += "NO_SIDE";
    }
  }
  return sides;
}

// Smallest x, largest x, largest |y| of the unfolded shape; the width of its line.
std::string extentOf(const SpriteShape& shape) {
  const bool circle = shape.cornerCount == 0;
  float least_x = circle ? -1.0f : 0.0f, most_x = circle ? 1.0f : 0.0f, most_y = circle ? 1.0f : 0.0f;
  for (uint32_t c = 0; c < shape.cornerCount; ++c) {
    const ShapeCorner corner = shape.corners[c];
    least_x = std::min(least_x, corner.x);
    most_x = std::max(most_x, corner.x);
    most_y = std::max(most_y, std::abs(corner.y));
  }
  if (shape.fold == Fold::diagonal) most_x = most_y = std::max(most_x, most_y);
  if (shape.fold != Fold::along) least_x = -most_x;
  return vec4(least_x, most_x, most_y, shape.lineWidth);
}

// One #define: an entry of each shape.
template <class Entry>
std::string define(const char* name, const Entry& entry) {
  std::string line = std::string("#define ") + name + " ";
  for (const SpriteShape& shape : kSpriteShapes) line += (&shape == kSpriteShapes ? "" : ",") + entry(shape);
  return line + "\n";
}

}  // namespace

std::string spriteShapeDefines() {
  using Of = const SpriteShape&;
  return "#define SHAPES " + std::to_string(kShapes) + "\n" +  //
         "#define ANNOUNCED_SCALE " + text(kAnnouncedScale) + "\n" + define("SHAPE_SIDES", sidesOf) +
         define("SHAPE_FOLDS", [](Of shape) { return text(float(shape.fold)); }) +
         define("SHAPE_RADII", [](Of shape) { return text(shape.radius); }) + define("SHAPE_EXTENTS", extentOf) +
         define(
             "SHAPE_FILLS",
             [](Of shape) { return vec4(shape.fillFull, shape.fillSpent, shape.cover, shape.turns ? 1.0f : 0.0f); }) +
         define("SHAPE_CHEQUERS", [](Of shape) { return text(shape.chequered ? 1.0f : 0.0f); }) +
         define("SHAPE_INNER_RINGS", [](Of shape) { return text(shape.innerRing); }) +
         define("SHAPE_GLOW_REACHES", [](Of shape) { return text(shape.glowReach); });
}

}  // namespace gw
