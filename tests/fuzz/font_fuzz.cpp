// The typeface: its metrics (JSON, when the input begins with a brace) or its atlas (PNG, else), beside the game's own
// other half. It is the only image that the game reads.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "render/text_font.h"
#include "tests/fuzz/fuzz_input.h"

namespace gw::fuzz {
namespace {

namespace fs = std::filesystem;

// A folder of assets of this process's own, which goes with it.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("gpuwars-font-fuzz-" + std::to_string(getpid()))) {
    fs::create_directories(path_ / "fonts");
    restore("neon.json");
    restore("neon.png");
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  void write(const char* name, const uint8_t* data, size_t size) const {
    std::ofstream(path_ / "fonts" / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), std::streamsize(size));
  }
  void restore(const char* name) const {
    fs::copy_file(fs::path(GW_ASSETS_DIR) / "fonts" / name, path_ / "fonts" / name,
                  fs::copy_options::overwrite_existing);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void read(const fs::path& assets) {
  try {
    const TextFont font = loadTextFont(assets);
    demand(font.atlas.size() == size_t(font.atlasSize.width) * size_t(font.atlasSize.height),
           "the atlas has another size");
    demand(std::isfinite(font.width_px("The quick brown fox", 20)), "a text has no width");
  } catch (const std::runtime_error& error) {
    demandSentence(error.what());
  }
}

}  // namespace
}  // namespace gw::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const gw::fuzz::Folder folder;
  const char* name = size > 0 && data[0] == '{' ? "neon.json" : "neon.png";
  folder.write(name, data, size);
  gw::fuzz::read(folder.path());
  folder.restore(name);
  return 0;
}
