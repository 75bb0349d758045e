// Pictures: read back from the bound target, written as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/gl_context.h"

namespace gw {

struct Image {
  PixelSize size;
  std::vector<uint8_t> rgb;  // three bytes a pixel, rows from the top
};

// What has been drawn into the bound target; waits for it. In a window call it before swap().
Image readPixels(PixelSize size);

// Writes a PNG by way of a temporary file beside it, so that an interrupted run leaves no half picture.
// Throws std::runtime_error with one sentence when the path cannot be written.
void writePng(const std::filesystem::path& path, const Image& image);

// Both of the above.
Image takeScreenshot(const std::filesystem::path& path, PixelSize size);

}  // namespace gw
