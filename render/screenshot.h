// Pictures: read back from the bound target, encoded as PNG.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_context.h"

namespace gw {

struct Image {
  PixelSize size;
  std::vector<uint8_t> rgb;  // three bytes a pixel, rows from the top
};

// What has been drawn into the bound target; waits for it. In a window call it before swap().
Image readPixels(PixelSize size);

// The bytes of a PNG file.
std::vector<uint8_t> encodePng(const Image& image);

}  // namespace gw
