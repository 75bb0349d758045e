#include "render/quad_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/gl_group.h"

namespace gw {
namespace {

enum Uniform : GLint { kPerPixel = 0 };  // locations in quad.vert

uint32_t byteOf(float share) {
  return uint32_t(std::clamp(share, 0.0f, 1.0f) * 255 + .5f);
}

uint32_t packRgba(const Rgba& colour) {
  return byteOf(colour.red) | byteOf(colour.green) << 8 | byteOf(colour.blue) << 16 | byteOf(colour.alpha) << 24;
}

}  // namespace

PassLayout QuadPass::layout() {
  return {"quad",
          "the user interface",
          {{VertexAttribute::Type::real, 2, offsetof(Vertex, x_px)},
           {VertexAttribute::Type::colour, 4, offsetof(Vertex, rgba)}}};
}

QuadPass::QuadPass(const std::filesystem::path& assets) : pass_(assets, layout()) {}

void QuadPass::push(float x_px, float y_px, Rgba colour) {
  vertices_.push_back({x_px, y_px, packRgba(colour)});
}

void QuadPass::triangle(float x0_px, float y0_px, float x1_px, float y1_px, float x2_px, float y2_px, Rgba colour) {
  push(x0_px, y0_px, colour);
  push(x1_px, y1_px, colour);
  push(x2_px, y2_px, colour);
}

void QuadPass::gradient(float left_px, float top_px, float width_px, float height_px, Rgba left, Rgba right) {
  const float right_px = left_px + width_px, bottom_px = top_px + height_px;
  push(left_px, top_px, left);
  push(left_px, bottom_px, left);
  push(right_px, top_px, right);
  push(right_px, top_px, right);
  push(left_px, bottom_px, left);
  push(right_px, bottom_px, right);
}

void QuadPass::rectangle(float left_px, float top_px, float width_px, float height_px, Rgba colour) {
  gradient(left_px, top_px, width_px, height_px, colour, colour);
}

void QuadPass::outline(float left_px, float top_px, float width_px, float height_px, float line_px, Rgba colour) {
  // The sides leave the corners to the top and the bottom: a translucent frame would show them twice.
  rectangle(left_px, top_px, width_px, line_px, colour);
  rectangle(left_px, top_px + height_px - line_px, width_px, line_px, colour);
  rectangle(left_px, top_px + line_px, line_px, height_px - 2 * line_px, colour);
  rectangle(left_px + width_px - line_px, top_px + line_px, line_px, height_px - 2 * line_px, colour);
}

void QuadPass::line(float x0_px, float y0_px, float x1_px, float y1_px, float width_px, Rgba colour) {
  const float dx = x1_px - x0_px, dy = y1_px - y0_px;
  const float length_px = std::hypot(dx, dy);
  if (length_px <= 0) return;
  const float beside_x = -dy / length_px * width_px / 2, beside_y = dx / length_px * width_px / 2;
  triangle(x0_px + beside_x, y0_px + beside_y, x0_px - beside_x, y0_px - beside_y, x1_px + beside_x, y1_px + beside_y,
           colour);
  triangle(x1_px + beside_x, y1_px + beside_y, x0_px - beside_x, y0_px - beside_y, x1_px - beside_x, y1_px - beside_y,
           colour);
}

void QuadPass::flush(PixelSize target) {
  if (vertices_.empty()) return;
  const GlGroup group("user interface");
  glUseProgram(pass_.program());
  glUniform2f(kPerPixel, 2.0f / float(target.width), 2.0f / float(target.height));
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  pass_.draw(vertices_);
  vertices_.clear();
}

}  // namespace gw
