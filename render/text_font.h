// The typeface as tools/make_font.py bakes it: where each glyph lies in the atlas and how far it advances.
// Measuring needs no GL context.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "render/gl_context.h"

namespace gw {

struct Glyph {
  float x = 0, y = 0, width = 0, height = 0;  // in the atlas, pixels; width 0: nothing to draw
  float left = 0, top = 0;                    // of the tile, from the pen and the baseline, units, y up
  float advance = 0;                          // units
};

struct TextFont {
  static constexpr uint32_t kFirst = 32, kLast = 126;  // printable ASCII

  std::array<Glyph, kLast - kFirst + 1> glyphs{};
  float pixelsPerUnit = 8;  // of the atlas
  float capHeight = 6;      // units; text sizes are heights of capitals
  float range = 1.6f;       // units that a distance of 255 steps spans
  float spacing = 1.7f;     // units after the last stroke of every glyph
  PixelSize atlasSize;
  std::vector<uint8_t> atlas;  // one byte a pixel: 255 on a stroke, 0 at `range` from it

  // Other characters than printable ASCII look like '?'.
  const Glyph& glyph(char character) const;

  // From the first stroke to the end of the last, for capitals of `size_px`.
  float width_px(std::string_view text, float size_px) const;
};

// Reads fonts/neon.json and its atlas in the folder of assets. Throws std::runtime_error, one sentence
// that names the file and what to do, when one is missing or damaged.
TextFont loadTextFont(const std::filesystem::path& assets);

}  // namespace gw
