#include "host/platform/asset_folder.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "host/platform/user_error.h"

namespace gw {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRemedy = ": reinstall the game, or name its folder of assets by --assets.";

[[noreturn]] void refuse(const std::string& what) {
  throw UserError(ExitCode::badFile, what + kRemedy);
}

// What the folder says it belongs to; empty: nothing that could be a version.
std::string versionOf(const fs::path& folder) {
  std::ifstream file(folder / "version");
  std::string version(32, '\0');
  file.read(version.data(), std::streamsize(version.size()));
  version.resize(size_t(file.gcount()));
  version.resize(std::min(version.size(), version.find_last_not_of("\r\n") + 1));
  const auto belongs = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-'; };
  return std::all_of(version.begin(), version.end(), belongs) ? version : "";
}

fs::path checked(const fs::path& folder) {
  std::error_code ignored;
  const std::string name = folder.string();
  if (!fs::is_directory(folder, ignored)) refuse("There is no folder of assets at " + name);
  const std::string version = versionOf(folder);
  if (version == GW_VERSION) return folder;
  if (version.empty())
    refuse(name + " does not say of which version its assets are, and this program needs " GW_VERSION);
  refuse(name + " holds the assets of gpuwars " + version + ", and this program is gpuwars " GW_VERSION);
}

}  // namespace

fs::path findAssetFolder(const fs::path& given) {
  if (!given.empty()) return checked(given);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  std::vector<fs::path> candidates{program.parent_path() / "assets",
                                   program.parent_path().parent_path() / "share/gpuwars/assets"};
  if (*GW_SOURCE_ASSETS) candidates.emplace_back(GW_SOURCE_ASSETS);  // empty in packages
  std::string places;
  for (const fs::path& folder : candidates) {
    if (fs::is_directory(folder, ignored)) return checked(folder);
    places += (places.empty() ? "at " : ", nor at ") + folder.string();
  }
  refuse("There is no folder of assets " + places);
}

}  // namespace gw
