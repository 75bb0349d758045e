// A picture that is drawn on without a GPU or a display: flat shapes with smooth edges, for diagrams in the docs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpu/math/plain_types.h"
#include "render/text_font.h"

namespace gw::bench {

struct Colour {
  float red, green, blue;  // 0 to 1, as a screen shows them
};

// Hue in turns; lightness 0 is black, 1 white.
Colour fromHue(float hue, float saturation, float lightness);

// Places and lengths are pixels from the upper left corner, y down.
class Canvas {
 public:
  Canvas(PixelSize size, const TextFont& font, Colour ground);

  void disc(Float2 middle, float radius, Colour colour);
  void ring(Float2 middle, float radius, float width, Colour colour);
  void square(Float2 middle, float half, float width, Colour colour);  // its outline
  void cross(Float2 middle, float half, float width, Colour colour);   // as an x
  void line(Float2 from, Float2 to, float width, Colour colour, float cover = 1.0f);
  void rectangle(Float2 low, Float2 high, Colour colour, float cover = 1.0f);
  // From its lower left corner; capitals are `size` high. Returns where it ends.
  float text(Float2 at, float size, std::string_view text, Colour colour);

  // As PNG. Throws std::runtime_error.
  void save(const std::string& path) const;

 private:
  // Paints where `distance`, in pixels from the shape's edge, is negative.
  template <class Distance>
  void paint(Float2 low, Float2 high, Colour colour, float cover, const Distance& distance);

  PixelSize size_;
  const TextFont& font_;
  std::vector<Colour> pixels_;
};

}  // namespace gw::bench
