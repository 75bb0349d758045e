// Reads files of the assets folder.
#pragma once

#include <filesystem>
#include <string>

namespace gw {

// The bytes of a file, e.g. readAsset(assets, "shaders/sprite.vert"). Throws std::runtime_error with one
// sentence that names the file and what to do.
std::string readAsset(const std::filesystem::path& assets, const std::string& name);

}  // namespace gw
