#include "game/asset_folder.h"

#include <system_error>

namespace gw {

namespace fs = std::filesystem;

fs::path findAssetFolder(const fs::path& given) {
  if (!given.empty()) return given;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path beside = program.parent_path() / "assets";
  const fs::path candidates[] = {beside, program.parent_path().parent_path() / "share/gpuwars/assets",
                                 fs::path(GW_SOURCE_ASSETS)};
  for (const fs::path& folder : candidates) {
    if (fs::is_regular_file(folder / "game.toml", ignored)) return folder;
  }
  return beside;
}

}  // namespace gw
