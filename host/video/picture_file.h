// One picture as a PNG file, whole or not at all.
#pragma once

#include <filesystem>

#include "host/platform/atomic_file.h"
#include "render/screenshot.h"

namespace gw {

// Throws FileError.
void writePicture(const std::filesystem::path& path, const Image& image, Sync sync = Sync::now);

}  // namespace gw
