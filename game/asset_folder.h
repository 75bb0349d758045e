// Where shaders, fonts and rule tables lie.
#pragma once

#include <filesystem>

namespace gw {

// `given` (--assets) when it is not empty. Else the first of: assets/ beside the program, share/gpuwars/assets
// beside its folder, and the source tree it was built from. When there is none the first is returned, so
// that the message about a missing file names a place where it could be.
std::filesystem::path findAssetFolder(const std::filesystem::path& given);

}  // namespace gw
