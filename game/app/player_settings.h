// The settings file for the commands that open a window; whatever is wrong with it is said on stderr.
#pragma once

#include "game/cli/command_line.h"
#include "game/settings/settings_file.h"

namespace gw {

// The file that --settings names, or the usual one.
SettingsFile settingsFileOf(const Options& options);

Settings readPlayerSettings(SettingsFile& file);
void writePlayerSettings(SettingsFile& file, const Settings& before, const Settings& now);

}  // namespace gw
