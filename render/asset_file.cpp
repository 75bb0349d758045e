#include "render/asset_file.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gw {

std::string readAsset(const std::filesystem::path& assets, const std::string& name) {
  const std::filesystem::path path = assets / name;
  std::ifstream file(path, std::ios::binary);
  // A folder opens without complaint and only fails when read.
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || std::filesystem::is_directory(path)) {
    throw std::runtime_error(
        "Cannot read " + path.string() +
        ": put the file back from the GpuWars package, or start GpuWars with its own assets folder.");
  }
  return text;
}

}  // namespace gw
