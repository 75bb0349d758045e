#include "host/video/picture_file.h"

namespace gw {

void writePicture(const std::filesystem::path& path, const Image& image, Sync sync) {
  writeFileAtomically(path, encodePng(image), sync);
}

}  // namespace gw
