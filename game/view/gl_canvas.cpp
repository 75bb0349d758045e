#include "game/view/gl_canvas.h"

#include <algorithm>

namespace gw {

GlCanvas::GlCanvas(QuadPass& quads, TextPass& text, PixelSize target)
    : quads_(quads), text_(text), target_(target), scale_(float(std::max(target.height, 1)) / kHeight) {}

void GlCanvas::rectangle(float left, float top, float width, float height, Rgba colour) {
  quads_.rectangle(left * scale_, top * scale_, width * scale_, height * scale_, colour);
}

void GlCanvas::gradient(float left, float top, float width, float height, Rgba from, Rgba to) {
  quads_.gradient(left * scale_, top * scale_, width * scale_, height * scale_, from, to);
}

void GlCanvas::outline(float left, float top, float width, float height, float line, Rgba colour) {
  quads_.outline(left * scale_, top * scale_, width * scale_, height * scale_, std::max(1.0f, line * scale_), colour);
}

void GlCanvas::line(float x0, float y0, float x1, float y1, float width, Rgba colour) {
  quads_.line(x0 * scale_, y0 * scale_, x1 * scale_, y1 * scale_, std::max(1.0f, width * scale_), colour);
}

void GlCanvas::triangle(float x0, float y0, float x1, float y1, float x2, float y2, Rgba colour) {
  quads_.triangle(x0 * scale_, y0 * scale_, x1 * scale_, y1 * scale_, x2 * scale_, y2 * scale_, colour);
}

void GlCanvas::text(std::string_view text, float x, float baseline, const TextStyle& style) {
  TextStyle pixels = style;
  pixels.size_px *= scale_;
  text_.add(text, x * scale_, baseline * scale_, pixels);
}

float GlCanvas::textWidth(std::string_view text, float size) const {
  return text_.font().width_px(text, size);
}

void GlCanvas::nextLayer() {
  quads_.flush(target_);
  text_.flush(target_);
}

}  // namespace gw
