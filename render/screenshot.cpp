#include "render/screenshot.h"

#include <GL/glew.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

#include "render/gl_objects.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace gw {
namespace {

void appendToFile(void* file, void* data, int size) {
  std::fwrite(data, 1, size_t(size), static_cast<std::FILE*>(file));
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

void writePng(const std::filesystem::path& path, const Image& image) {
  const auto fail = [&](const std::string& reason) {
    return std::runtime_error("Cannot write the picture " + path.string() + " (" + reason +
                              "): choose a folder that exists and that you may write to, with room on its disk.");
  };
  // The process id keeps two runs that write the same picture out of each other's way.
  std::filesystem::path temporary = path;
  temporary += std::string(".").append(std::to_string(getpid())).append(".part");
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) throw fail(std::generic_category().message(errno));
  stbi_write_png_compression_level = 5;  // a third of the time of the default 8, for pictures a few per cent larger
  const bool encoded = stbi_write_png_to_func(appendToFile, file, image.size.width, image.size.height, 3,
                                              image.rgb.data(), image.size.width * 3) != 0;
  const bool written = std::ferror(file) == 0;
  const bool closed = std::fclose(file) == 0;
  std::error_code error;
  if (!encoded || !written || !closed) {
    std::filesystem::remove(temporary, error);
    throw fail("the disk did not take it");
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    throw fail(reason);
  }
}

Image takeScreenshot(const std::filesystem::path& path, PixelSize size) {
  Image image = readPixels(size);
  writePng(path, image);
  return image;
}

}  // namespace gw
