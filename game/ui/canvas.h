// What screens draw on: rectangles and text in units of 1/720 of the window's height, so that every
// screen looks the same at every size. Screens know nothing of OpenGL; tests look at what they drew.
#pragma once

#include <string_view>

#include "render/camera.h"
#include "render/text_pass.h"

namespace gw {

class Canvas {
 public:
  static constexpr float kHeight = 720;

  virtual ~Canvas() = default;
  virtual float width() const = 0;  // kHeight times the window's aspect

  virtual void rectangle(float left, float top, float width, float height, Rgba colour) = 0;
  virtual void gradient(float left, float top, float width, float height, Rgba from, Rgba to) = 0;  // left to right
  virtual void outline(float left, float top, float width, float height, float line, Rgba colour) = 0;
  virtual void line(float x0, float y0, float x1, float y1, float width, Rgba colour) = 0;
  virtual void triangle(float x0, float y0, float x1, float y1, float x2, float y2, Rgba colour) = 0;
  // TextStyle::size_px is in canvas units here. `baseline` runs down from the top, as everything.
  virtual void text(std::string_view text, float x, float baseline, const TextStyle& style) = 0;
  virtual float textWidth(std::string_view text, float size) const = 0;

  // What follows covers everything before it; within a layer text lies over shapes.
  virtual void nextLayer() = 0;
};

}  // namespace gw
