// Comparing pictures with a tolerance, and golden pictures kept in tests/render/golden_images.
#pragma once

#include <filesystem>
#include <string>

#include "render/screenshot.h"

namespace gw {

// In steps of 0..255 per colour channel.
struct ImageDifference {
  bool sameSize = false;
  int largest = 255;
  double mean = 255;
};

// Drivers round the edges of shapes differently: a few steps at many pixels, many steps at none. One pixel of
// displacement is far outside both (a test holds it to that).
inline constexpr int kLargestDifference = 48;
inline constexpr double kMeanDifference = 0.25;

ImageDifference compareImages(const Image& a, const Image& b);
bool withinTolerance(const ImageDifference& difference);

// Both throw std::runtime_error: when the file cannot be written, and when it is not a readable PNG.
void writePng(const std::filesystem::path& path, const Image& image);
Image readPng(const std::filesystem::path& path);

// The same picture moved to the right; the left edge is repeated.
Image shiftedImage(const Image& image, int right_px);

// Empty when the picture agrees with tests/render/golden_images/name; else says by how much it differs and where the
// picture was left for a look. With GW_UPDATE_GOLDEN_IMAGES set it writes the golden picture instead.
std::string compareWithGolden(const Image& image, const std::string& name);

}  // namespace gw
