#include "game/settings/settings_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "game/settings/settings_edit.h"
#include "game/settings/settings_lines.h"
#include "host/platform/atomic_file.h"

namespace gw {

namespace fs = std::filesystem;

namespace {

fs::path folderIn(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

// What the file holds, as text. None when there is no file; when it cannot be read a sentence is added.
std::optional<std::string> textOf(const fs::path& path, std::vector<std::string>& sentences) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty() || status.type() == fs::file_type::not_found) return std::nullopt;
  if (!fs::is_regular_file(status)) {
    sentences.push_back(
        fmt::format("{} is not a plain file that can be read; the default settings are used, give "
                    "another with --settings FILE.",
                    path.string()));
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) {
    text.resize(kMaxSettingsText + 1);  // enough to see that there is more
    file.read(text.data(), std::streamsize(text.size()));
    text.resize(size_t(file.gcount()));
  }
  if (!file && !file.eof()) {
    sentences.push_back(
        fmt::format("{} cannot be read; the default settings are used, check who may read the file.", path.string()));
    return std::nullopt;
  }
  return text;
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

Settings SettingsFile::read(std::vector<std::string>& sentences) const {
  const std::optional<std::string> text = textOf(path_, sentences);
  if (!text) return {};
  const ReadSettings result = readSettings(*text, path_.string());
  sentences.insert(sentences.end(), result.complaints.begin(), result.complaints.end());
  return result.settings;
}

void SettingsFile::write(const Settings& before, const Settings& now, std::vector<std::string>& sentences) {
  if (!unsavedSince_) unsavedSince_ = before;
  const auto failed = [&](const std::string& why) {
    sentences.push_back(fmt::format("The settings hold until the game ends, but were not saved: {}.", why));
  };
  if (path_.empty()) return failed("neither XDG_CONFIG_HOME nor HOME names a folder; set one, or give --settings FILE");
  try {
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path());
    std::vector<std::string> unreadable;
    const std::optional<std::string> there = textOf(path_, unreadable);
    const ReadSettings read = there ? readSettings(*there, path_.string()) : ReadSettings();
    const Settings wanted = mergedSettings(read.settings, *unsavedSince_, now);
    const std::optional<std::string> changed = there ? editSettings(*there, read, wanted) : std::nullopt;
    if (!unreadable.empty() || read.damaged || (there && !changed)) {
      const fs::path kept = keepCopy();
      if (!kept.empty()) {
        sentences.push_back(fmt::format("What was in {} before is kept as {}.", path_.string(), kept.string()));
      }
    }
    const std::string text = changed ? *changed : writeSettings(wanted, read.unknown);
    writeFileAtomically(path_, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
    unsavedSince_.reset();
  } catch (const FileError& error) {
    failed(error.what());
  } catch (const fs::filesystem_error& error) {
    failed(fmt::format("{} cannot be written: {}; choose another place with --settings FILE", path_.string(),
                       error.code().message()));
  }
}

// A free name, so that no earlier one is lost either. Empty when the file has gone meanwhile.
fs::path SettingsFile::keepCopy() const {
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
