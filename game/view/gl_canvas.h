// The canvas that screens draw on, as OpenGL passes.
#pragma once

#include "game/ui/canvas.h"
#include "render/quad_pass.h"

namespace gw {

class GlCanvas final : public Canvas {
 public:
  GlCanvas(QuadPass& quads, TextPass& text, PixelSize target);

  float width() const override { return float(target_.width) / scale_; }
  void rectangle(float left, float top, float width, float height, Rgba colour) override;
  void gradient(float left, float top, float width, float height, Rgba from, Rgba to) override;
  void outline(float left, float top, float width, float height, float line, Rgba colour) override;
  void line(float x0, float y0, float x1, float y1, float width, Rgba colour) override;
  void triangle(float x0, float y0, float x1, float y1, float x2, float y2, Rgba colour) override;
  void text(std::string_view text, float x, float baseline, const TextStyle& style) override;
  float textWidth(std::string_view text, float size) const override;
  void nextLayer() override;  // also draws the last layer

 private:
  QuadPass& quads_;
  TextPass& text_;
  PixelSize target_;
  float scale_;  // pixels per canvas unit
};

}  // namespace gw
