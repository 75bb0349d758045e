// A canvas that only remembers what was drawn on it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "game/ui/canvas.h"

namespace gw {

class RememberingCanvas : public Canvas {
 public:
  struct Text {
    std::string text;
    float x, baseline;
    TextStyle style;
  };
  struct Bar {
    float left, top, width, height;
  };

  float width() const override { return 1280; }
  void rectangle(float left, float top, float width, float height, Rgba) override {
    bars.push_back({left, top, width, height});
  }
  void gradient(float left, float top, float width, float height, Rgba, Rgba) override {
    gradients.push_back({left, top, width, height});
  }
  void outline(float left, float top, float width, float height, float, Rgba) override {
    outlines.push_back({left, top, width, height});
  }
  void line(float, float, float, float, float, Rgba) override { ++lines; }
  void triangle(float, float, float, float, float, float, Rgba) override { ++triangles; }
  void text(std::string_view text, float x, float baseline, const TextStyle& style) override {
    texts.push_back({std::string(text), x, baseline, style});
  }
  float textWidth(std::string_view text, float size) const override { return float(text.size()) * size * 0.9f; }
  void nextLayer() override {}

  bool says(const std::string& what) const {
    return std::any_of(texts.begin(), texts.end(), [&](const Text& t) {
      return t.text.find(what) != std::string::npos && t.style.colour.alpha > 0.05f;
    });
  }

  // What lies outside of the canvas, or empty.
  std::string outside() const { return outside({0, 0, width(), kHeight}); }
  // The same for a box on it.
  std::string outside(const Bar& box) const {
    for (const Text& text : texts) {
      const float across = textWidth(text.text, text.style.size_px);
      const float left = text.style.align == TextAlign::left     ? text.x
                         : text.style.align == TextAlign::centre ? text.x - across / 2
                                                                 : text.x - across;
      if (left < box.left || left + across > box.left + box.width) return text.text;
      if (text.baseline < box.top || text.baseline > box.top + box.height) return text.text;
    }
    return "";
  }

  std::vector<Text> texts;
  std::vector<Bar> bars, gradients, outlines;
  int lines = 0, triangles = 0;
};

}  // namespace gw
