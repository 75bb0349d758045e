// Where a test finds the game's assets: GW_ASSETS, beside the program (a pack on another machine), or in the source
// tree.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace gw {

inline std::filesystem::path findAssets(const std::filesystem::path& source) {
  if (const char* given = std::getenv("GW_ASSETS")) return given;
  std::error_code ignored;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "assets";
  return std::filesystem::is_directory(beside, ignored) ? beside : source;
}

}  // namespace gw
