#include "game/cli/desktop_options.h"

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {

void SizeOptions::declareSize(OptionSet& options) {
  options.integer("--width", "of the window or picture, in pixels (1280)", 320, 7680, width_px);
  options.integer("--height", "of the window or picture, in pixels (720)", 200, 4320, height_px);
}

void DesktopOptions::declareDesktop(OptionSet& options) {
  declareSize(options);
  options.flag("--fullscreen", "fill the screen", fullscreen);
  options.flag("--mute", "no sound", mute);
  options.path("--settings", "the settings file (~/.config/gpuwars/settings.toml)", "FILE", settingsPath, kDiagnostics);
}

}  // namespace gw
