// Where the settings live. Whatever is wrong there, the game goes on, and nothing of the player's is lost silently.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/settings/settings_text.h"

namespace gw {

// $XDG_CONFIG_HOME/gpuwars/settings.toml, else ~/.config/gpuwars/settings.toml; empty when the environment names
// neither folder.
std::filesystem::path usualSettingsPath();

class SettingsFile {
 public:
  // An empty path: the settings of this session are not kept.
  explicit SettingsFile(std::filesystem::path path) : path_(std::move(path)) {}

  // What is there, defaults for the rest. Adds one sentence for each thing that is wrong; none when there is no file.
  Settings read(std::vector<std::string>& sentences) const;

  // Reads the file again and puts into it what differs between `before` and `now`, and what an earlier write() could
  // not; all else in it stays as another program may have written it meanwhile. Writes it whole or not at all. A file
  // that had wrong values, or that cannot be changed in its place, is first kept beside it as settings.toml.bad (or
  // .bad-2 and so on). Adds a sentence when that was done, and one when nothing could be written.
  void write(const Settings& before, const Settings& now, std::vector<std::string>& sentences);

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path keepCopy() const;

  std::filesystem::path path_;
  std::optional<Settings> unsavedSince_;  // the settings before the first change that is not in the file yet
};

}  // namespace gw
