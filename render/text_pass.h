// Text in screen pixels (x right, y down, from the upper left corner) at any size: glowing tubes of one
// typeface. Collected, then drawn by one call per frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "render/instanced_pass.h"
#include "render/text_font.h"

namespace gw {

enum class TextAlign { left, centre, right };

struct TextStyle {
  float size_px = 18;  // height of a capital
  Rgba colour;
  TextAlign align = TextAlign::left;
  float glow = 0.35f;    // light around the strokes, 0 none .. 1 a bright sign
  float weight = 0.36f;  // half a stroke, in sixths of a capital's height; 0.2 thin .. 0.6 heavy
};

class TextPass {
 public:
  // Throws std::runtime_error, one sentence, when the font or a shader is missing or damaged.
  explicit TextPass(const std::filesystem::path& assets);

  // (x, y) is where the baseline starts, has its middle or ends.
  void add(std::string_view text, float x_px, float baseline_px, const TextStyle& style);

  // Draws what was collected over the picture and forgets it.
  void flush(PixelSize target);

  const TextFont& font() const { return font_; }

 private:
  struct Instance {
    float left_px, top_px, width_px, height_px;
    float u0, v0, u1, v1;  // in the atlas, 0..1
    float unit_px, weight, glow;
    uint32_t rgba;  // bytes red, green, blue, alpha
  };

  static PassLayout layout();

  TextFont font_;
  InstancedPass<Instance> pass_;
  GlTexture atlas_;
  std::vector<Instance> instances_;
};

}  // namespace gw
