#include "game/window_display.h"

#include <SDL.h>

#include <cstdlib>

#include "game/user_error.h"

namespace gw {
namespace {

bool set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

void chooseDisplay() {
  if (set("SDL_VIDEODRIVER") || set("WAYLAND_DISPLAY")) return;
  if (!set("DISPLAY")) {
    throw UserError(ExitCode::failedRun,
                    "No display: neither DISPLAY nor WAYLAND_DISPLAY is set; use --headless, or start GpuWars in a "
                    "desktop session.");
  }
  SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
}

}  // namespace gw
