// The player's settings and their file, for the sessions with a window. Problems with the file are printed on stderr.
#pragma once

#include "game/cli/desktop_options.h"
#include "game/settings/settings_file.h"

namespace gw {

struct PlayerSettings {
  // Reads the file that --settings names, or the default one.
  explicit PlayerSettings(const DesktopOptions& options);

  // Writes what has changed since `before`, if anything has.
  void write(const Settings& before);

  SettingsFile file;
  Settings now;
};

}  // namespace gw
