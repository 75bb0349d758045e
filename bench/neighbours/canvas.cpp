#include "bench/neighbours/canvas.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace gw::bench {

Colour fromHue(float hue, float saturation, float lightness) {
  const float most = saturation * std::min(lightness, 1.0f - lightness);
  const auto channel = [&](float offset) {
    const float k = std::fmod(offset + hue * 12.0f, 12.0f);
    return lightness - most * std::max(-1.0f, std::min({k - 3.0f, 9.0f - k, 1.0f}));
  };
  return {channel(0.0f), channel(8.0f), channel(4.0f)};
}

Canvas::Canvas(PixelSize size, const TextFont& font, Colour ground)
    : size_(size), font_(font), pixels_(size_t(size.width) * size_t(size.height), ground) {}

template <class Distance>
void Canvas::paint(Float2 low, Float2 high, Colour colour, float cover, const Distance& distance) {
  const int left = std::max(0, int(std::floor(low.x)) - 1), right = std::min(size_.width, int(std::ceil(high.x)) + 1);
  const int top = std::max(0, int(std::floor(low.y)) - 1), bottom = std::min(size_.height, int(std::ceil(high.y)) + 1);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const float outside = distance(float(x) + 0.5f, float(y) + 0.5f);
      // In quarters: smaller files, and hardly worse to look at.
      const float share = cover * std::floor(std::clamp(0.5f - outside, 0.0f, 1.0f) * 4.0f + 0.5f) * 0.25f;
      Colour& pixel = pixels_[size_t(y) * size_t(size_.width) + size_t(x)];
      pixel.red += share * (colour.red - pixel.red);
      pixel.green += share * (colour.green - pixel.green);
      pixel.blue += share * (colour.blue - pixel.blue);
    }
  }
}

void Canvas::disc(Float2 middle, float radius, Colour colour) {
  paint({middle.x - radius, middle.y - radius}, {middle.x + radius, middle.y + radius}, colour, 1.0f,
        [&](float x, float y) { return std::hypot(x - middle.x, y - middle.y) - radius; });
}

void Canvas::ring(Float2 middle, float radius, float width, Colour colour) {
  const float reach = radius + width;
  paint({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}, colour, 1.0f,
        [&](float x, float y) { return std::fabs(std::hypot(x - middle.x, y - middle.y) - radius) - 0.5f * width; });
}

void Canvas::square(Float2 middle, float half, float width, Colour colour) {
  const float reach = half + width;
  paint({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}, colour, 1.0f,
        [&](float x, float y) {
          return std::fabs(std::max(std::fabs(x - middle.x), std::fabs(y - middle.y)) - half) - 0.5f * width;
        });
}

void Canvas::cross(Float2 middle, float half, float width, Colour colour) {
  line({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, width, colour);
  line({middle.x - half, middle.y + half}, {middle.x + half, middle.y - half}, width, colour);
}

void Canvas::line(Float2 from, Float2 to, float width, Colour colour, float cover) {
  const float alongX = to.x - from.x, alongY = to.y - from.y, length2 = alongX * alongX + alongY * alongY;
  paint({std::min(from.x, to.x) - width, std::min(from.y, to.y) - width},
        {std::max(from.x, to.x) + width, std::max(from.y, to.y) + width}, colour, cover, [&](float x, float y) {
          const float along = length2 > 0.0f ? ((x - from.x) * alongX + (y - from.y) * alongY) / length2 : 0.0f;
          const float near = std::clamp(along, 0.0f, 1.0f);
          return std::hypot(x - from.x - near * alongX, y - from.y - near * alongY) - 0.5f * width;
        });
}

void Canvas::rectangle(Float2 low, Float2 high, Colour colour, float cover) {
  paint(low, high, colour, cover, [&](float x, float y) {
    return std::max({low.x - x, x - high.x, low.y - y, y - high.y});
  });
}

float Canvas::text(Float2 at, float size, std::string_view text, Colour colour) {
  const float scale = size / font_.capHeight;  // pixels of a unit
  for (const char character : text) {
    const Glyph& glyph = font_.glyph(character);
    const float toAtlas = font_.pixelsPerUnit / scale;
    const Float2 corner{at.x + glyph.left * scale, at.y - glyph.top * scale};
    const Float2 end{corner.x + glyph.width / toAtlas, corner.y + glyph.height / toAtlas};
    paint(corner, end, colour, 1.0f, [&](float x, float y) {
      const int across = int(glyph.x + (x - corner.x) * toAtlas), down = int(glyph.y + (y - corner.y) * toAtlas);
      const bool inside = x > corner.x && y > corner.y && x < end.x && y < end.y;
      if (!inside) return 1.0f;
      const uint8_t value = font_.atlas[size_t(down) * size_t(font_.atlasSize.width) + size_t(across)];
      const float fromStroke = font_.range * scale * (1.0f - float(value) / 255.0f);
      return fromStroke - 0.6f;  // half as wide as a stroke
    });
    at.x += glyph.advance * scale;
  }
  return at.x;
}

void Canvas::save(const std::string& path) const {
  std::vector<uint8_t> rgb;
  for (const Colour& pixel : pixels_) {
    for (const float channel : {pixel.red, pixel.green, pixel.blue}) {
      rgb.push_back(uint8_t(std::clamp(channel, 0.0f, 1.0f) * 255.0f + 0.5f));
    }
  }
  // Flat shapes make smaller files without filters.
  stbi_write_force_png_filter = 0;
  stbi_write_png_compression_level = 30;
  if (!stbi_write_png(path.c_str(), size_.width, size_.height, 3, rgb.data(), size_.width * 3)) {
    throw std::runtime_error("Cannot write the picture " + path + "; name a folder that exists and can be written.");
  }
}

}  // namespace gw::bench
