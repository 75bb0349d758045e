// Settings as TOML. A wrong value costs that value only: it is named, and its default is used.
#pragma once

#include <string>
#include <vector>

#include "game/settings/settings.h"

namespace gw {

struct ReadSettings {
  Settings settings;
  std::vector<std::string> complaints;  // one sentence each
  // Something would be lost by writing these settings over the text they came from: it is no TOML, or a value is wrong.
  bool damaged = false;
  std::vector<std::string> wrong;  // the keys of wrong values, as "sound.music"
  // Keys that this version does not know, as lines of TOML by section ("": before the first one).
  std::vector<std::pair<std::string, std::string>> unknown;
};

inline constexpr size_t kMaxSettingsText = 65536;  // bytes

// `name` is how the file is called in complaints. Never throws.
ReadSettings readSettings(const std::string& text, const std::string& name);

// With `unknown` as read: what another version understands outlives this one.
std::string writeSettings(const Settings& settings,
                          const std::vector<std::pair<std::string, std::string>>& unknown = {});

}  // namespace gw
