#include "game/settings/settings_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "game/files/atomic_file.h"

namespace gw {

namespace fs = std::filesystem;

namespace {

fs::path folderIn(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

fs::path usualSettingsPath() {
  fs::path folder = folderIn("XDG_CONFIG_HOME");
  if (folder.empty()) {
    folder = folderIn("HOME");
    if (folder.empty()) return {};
    folder /= ".config";
  }
  return folder / "gpuwars" / "settings.toml";
}

Settings SettingsFile::read(std::vector<std::string>& sentences) {
  damaged_ = false;
  unknown_.clear();
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (path_.empty() || status.type() == fs::file_type::not_found) return {};
  if (!fs::is_regular_file(status)) {
    sentences.push_back(
        fmt::format("{} is not a plain file that can be read; the default settings are used, give "
                    "another with --settings FILE.",
                    path_.string()));
    damaged_ = true;
    return {};
  }
  std::ifstream file(path_, std::ios::binary);
  std::string text;
  if (file) {
    text.resize(kMaxSettingsText + 1);  // enough to see that there is more
    file.read(text.data(), std::streamsize(text.size()));
    text.resize(size_t(file.gcount()));
  }
  if (!file && !file.eof()) {
    sentences.push_back(
        fmt::format("{} cannot be read; the default settings are used, check who may read the file.", path_.string()));
    damaged_ = true;
    return {};
  }
  ReadSettings result = readSettings(text, path_.string());
  damaged_ = result.damaged;
  unknown_ = std::move(result.unknown);
  sentences.insert(sentences.end(), result.complaints.begin(), result.complaints.end());
  return result.settings;
}

void SettingsFile::write(const Settings& settings, std::vector<std::string>& sentences) {
  const auto failed = [&](const std::string& why) {
    sentences.push_back(fmt::format("The settings hold until the game ends, but were not saved: {}.", why));
  };
  if (path_.empty()) return failed("neither XDG_CONFIG_HOME nor HOME names a folder; set one, or give --settings FILE");
  try {
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path());
    if (damaged_) {
      const fs::path kept = keepDamaged();
      if (!kept.empty())
        sentences.push_back(fmt::format("What was wrong in {} is kept as {}.", path_.string(), kept.string()));
      damaged_ = false;
    }
    const std::string text = writeSettings(settings, unknown_);
    writeFileAtomically(path_, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  } catch (const FileError& error) {
    failed(error.what());
  } catch (const fs::filesystem_error& error) {
    failed(fmt::format("{} cannot be written: {}; choose another place with --settings FILE", path_.string(),
                       error.code().message()));
  }
}

// A free name, so that no earlier one is lost either. Empty when the file has gone meanwhile.
fs::path SettingsFile::keepDamaged() const {
  if (!fs::exists(path_)) return {};
  for (uint32_t number = 1;; ++number) {
    const fs::path kept = path_.string() + (number == 1 ? ".bad" : fmt::format(".bad-{}", number));
    if (fs::exists(fs::symlink_status(kept))) continue;
    std::error_code error;
    if (!fs::copy_file(path_, kept, error)) {
      std::error_code ignored;
      fs::remove(kept, ignored);  // half a copy is none
      throw fs::filesystem_error("", kept, error);
    }
    return kept;
  }
}

}  // namespace gw
