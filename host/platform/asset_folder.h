// Where shaders, fonts and rule tables lie.
#pragma once

#include <filesystem>

namespace gw {

// `given` (--assets) when it is not empty. Else the first of: assets/ beside the program, share/gpuwars/assets
// beside its folder, and the source tree it was built from. Throws UserError when there is none, and when its file
// `version` does not hold this program's version: shaders, tables and sounds belong to one release.
std::filesystem::path findAssetFolder(const std::filesystem::path& given);

}  // namespace gw
