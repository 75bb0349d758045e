#include "host/platform/window_display.h"

#include <SDL.h>

#include <cstdlib>

#include "host/platform/user_error.h"

namespace gw {
namespace {

bool set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

void chooseDisplay() {
  if (set("SDL_VIDEODRIVER") || set("SDL_VIDEO_DRIVER")) return;
  const bool x11 = set("DISPLAY"), wayland = set("WAYLAND_DISPLAY");
  if (!x11 && !wayland) {
    throw UserError(ExitCode::failedRun,
                    "No display: neither DISPLAY nor WAYLAND_DISPLAY is set; use --headless, or start GpuWars in a "
                    "desktop session.");
  }
  // Where there are both, versions of SDL differ in which they try first.
  if (x11) SDL_SetHint(SDL_HINT_VIDEODRIVER, wayland ? "x11,wayland" : "x11");
}

}  // namespace gw
