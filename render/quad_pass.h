// Plain rectangles and lines in screen pixels (x right, y down, from the upper left corner): bars, frames
// and shades of the user interface. Collected, then drawn at once in the order they were given.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/instanced_pass.h"

namespace gw {

class QuadPass {
 public:
  explicit QuadPass(const std::filesystem::path& assets);

  void rectangle(float left_px, float top_px, float width_px, float height_px, Rgba colour);
  // Colours run from left to right.
  void gradient(float left_px, float top_px, float width_px, float height_px, Rgba left, Rgba right);
  // A frame whose lines lie inside the rectangle.
  void outline(float left_px, float top_px, float width_px, float height_px, float line_px, Rgba colour);
  void line(float x0_px, float y0_px, float x1_px, float y1_px, float width_px, Rgba colour);
  // Counter-clockwise or clockwise, both are drawn.
  void triangle(float x0_px, float y0_px, float x1_px, float y1_px, float x2_px, float y2_px, Rgba colour);

  // Draws what was collected over the picture (ordinary alpha blending) and forgets it.
  void flush(PixelSize target);

 private:
  struct Vertex {
    float x_px, y_px;
    uint32_t rgba;  // bytes red, green, blue, alpha
  };
  void push(float x_px, float y_px, Rgba colour);

  static PassLayout layout();

  TrianglePass<Vertex> pass_;
  std::vector<Vertex> vertices_;
};

}  // namespace gw
