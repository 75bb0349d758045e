// Whether a file is a film, as far as its frame tells.
#pragma once

#include <filesystem>

namespace gw {

// MP4: boxes from the first byte to the last, its type first, its index and its pictures among them. A film that was
// cut short ends in the middle of a box, or has no index.
bool isWholeMp4(const std::filesystem::path& path);

}  // namespace gw
