// Icons are the outlines of the table of shapes: closed, within their radius, and no two alike.
#include "game/ui/shape_icon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/game/ui/remembering_canvas.h"

namespace gw {
namespace {

class LineCanvas : public RememberingCanvas {
 public:
  struct Line {
    float x0, y0, x1, y1;
  };
  void line(float x0, float y0, float x1, float y1, float, Rgba) override { drawn.push_back({x0, y0, x1, y1}); }
  std::vector<Line> drawn;
};

LineCanvas iconOf(uint32_t shape) {
  LineCanvas canvas;
  drawShapeIcon(canvas, Shape(shape), 100, 50, 10, Rgba{});
  return canvas;
}

// How many lines meet at each corner; -0 and rounding aside.
std::map<std::pair<int, int>, int> meetings(const LineCanvas& canvas) {
  std::map<std::pair<int, int>, int> at;
  for (const LineCanvas::Line& line : canvas.drawn) {
    ++at[{int(std::lround(line.x0 * 100)), int(std::lround(line.y0 * 100))}];
    ++at[{int(std::lround(line.x1 * 100)), int(std::lround(line.y1 * 100))}];
  }
  return at;
}

TEST(shape_icon, every_outline_is_closed_and_within_its_radius) {
  for (uint32_t shape = 0; shape < kShapes; ++shape) {
    const LineCanvas canvas = iconOf(shape);
    ASSERT_GE(canvas.drawn.size(), 3u) << shape;
    for (const auto& [corner, lines] : meetings(canvas)) {
      EXPECT_EQ(lines, 2) << "shape " << shape << " at " << corner.first << ", " << corner.second;
      EXPECT_LE(std::hypot(corner.first / 100.0 - 100, corner.second / 100.0 - 50), 11.5) << shape;
    }
  }
}

TEST(shape_icon, no_two_enemies_have_the_same) {
  std::set<std::string> icons;
  for (uint32_t shape = 0; shape < kEnemyShapes; ++shape) {
    const LineCanvas canvas = iconOf(shape);
    std::string icon = std::to_string(canvas.bars.size()) + " bars";
    for (const auto& [corner, lines] : meetings(canvas)) {
      icon += " " + std::to_string(corner.first) + "," + std::to_string(corner.second);
    }
    icons.insert(icon);
  }
  EXPECT_EQ(icons.size(), kEnemyShapes);
}

}  // namespace
}  // namespace gw
