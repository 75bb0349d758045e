// Settings as the lines of their file: what each key is, and how its value is written in TOML.
#pragma once

#include <string>
#include <vector>

#include "game/settings/settings.h"

namespace gw {

struct SettingsLine {
  std::string section, key, value;
  friend bool operator==(const SettingsLine&, const SettingsLine&) = default;
};

// All of them, section by section: the same keys in the same order whatever the settings are.
std::vector<SettingsLine> settingsLines(const Settings& settings);

// What the file has, with what differs between `before` and `now` as it is now: two who change different things both
// get their way.
Settings mergedSettings(const Settings& file, const Settings& before, const Settings& now);

}  // namespace gw
