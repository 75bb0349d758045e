#include "tests/render/image_compare.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace gw {

ImageDifference compareImages(const Image& a, const Image& b) {
  if (a.size.width != b.size.width || a.size.height != b.size.height || a.rgb.empty()) return {};
  int largest = 0;
  uint64_t sum = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) {
    const int difference = std::abs(int(a.rgb[i]) - int(b.rgb[i]));
    largest = std::max(largest, difference);
    sum += uint64_t(difference);
  }
  return {true, largest, double(sum) / double(a.rgb.size())};
}

bool withinTolerance(const ImageDifference& difference) {
  return difference.sameSize && difference.largest <= kLargestDifference && difference.mean <= kMeanDifference;
}

Image readPng(const std::filesystem::path& path) {
  Image image;
  uint8_t* rgb = stbi_load(path.c_str(), &image.size.width, &image.size.height, nullptr, 3);
  if (rgb == nullptr) throw std::runtime_error("Cannot read the picture " + path.string());
  image.rgb.assign(rgb, rgb + size_t(image.size.width) * size_t(image.size.height) * 3);
  stbi_image_free(rgb);
  return image;
}

Image shiftedImage(const Image& image, int right_px) {
  Image shifted = image;
  for (int y = 0; y < image.size.height; ++y) {
    for (int x = 0; x < image.size.width; ++x) {
      const size_t to = size_t(y * image.size.width + x) * 3;
      const size_t from = size_t(y * image.size.width + std::max(x - right_px, 0)) * 3;
      std::copy_n(image.rgb.begin() + ptrdiff_t(from), 3, shifted.rgb.begin() + ptrdiff_t(to));
    }
  }
  return shifted;
}

void writePng(const std::filesystem::path& path, const Image& image) {
  const std::vector<uint8_t> bytes = encodePng(image);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!file.flush()) throw std::runtime_error(path.string() + " cannot be written");
}

std::string compareWithGolden(const Image& image, const std::string& name) {
  const std::filesystem::path golden = std::filesystem::path(GW_SOURCE_DIR) / "tests/render/golden_images" / name;
  if (std::getenv("GW_UPDATE_GOLDEN_IMAGES") != nullptr) {
    writePng(golden, image);
    return "";
  }
  const ImageDifference difference = compareImages(image, readPng(golden));
  if (withinTolerance(difference)) return "";
  const std::filesystem::path seen = std::filesystem::current_path() / ("differs_" + name);
  writePng(seen, image);
  return "largest difference " + std::to_string(difference.largest) + ", mean " + std::to_string(difference.mean) +
         (difference.sameSize ? "" : ", sizes differ") + "; what was drawn: " + seen.string();
}

}  // namespace gw
