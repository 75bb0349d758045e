#include "render/screenshot.h"

#include <GL/glew.h>

#include <algorithm>
#include <new>

#include "render/gl_objects.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace gw {
namespace {

void append(void* bytes, void* data, int size) {
  auto& all = *static_cast<std::vector<uint8_t>*>(bytes);
  const auto* first = static_cast<const uint8_t*>(data);
  all.insert(all.end(), first, first + size);
}

}  // namespace

Image readPixels(PixelSize size) {
  const size_t row_bytes = size_t(size.width) * 3;
  Image image{size, std::vector<uint8_t>(row_bytes * size_t(size.height))};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  checkGl("reading the picture back");
  // OpenGL counts rows from below.
  for (int low = 0, high = size.height - 1; low < high; ++low, --high) {
    std::swap_ranges(image.rgb.begin() + ptrdiff_t(row_bytes) * low,
                     image.rgb.begin() + ptrdiff_t(row_bytes) * (low + 1),
                     image.rgb.begin() + ptrdiff_t(row_bytes) * high);
  }
  return image;
}

std::vector<uint8_t> encodePng(const Image& image) {
  std::vector<uint8_t> bytes;
  stbi_write_png_compression_level = 5;  // a third of the time of the default 8, for pictures a few per cent larger
  if (stbi_write_png_to_func(append, &bytes, image.size.width, image.size.height, 3, image.rgb.data(),
                             image.size.width * 3) == 0) {
    throw std::bad_alloc();
  }
  return bytes;
}

}  // namespace gw
