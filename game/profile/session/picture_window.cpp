// The window of a session. Only in builds with GW_WINDOW.
#include <SDL.h>

#include <stdexcept>

#include "game/profile/session/picture.h"
#include "host/platform/user_error.h"
#include "host/platform/window_display.h"
#include "render/gl_context_sdl.h"

namespace gw::profile {

Screen openWindow(PixelSize size) {
  chooseDisplay();
  WindowOptions window;
  window.title = "GpuWars: profile";
  window.size = size;
  window.verticalSync = false;  // frames as fast as they come
  try {
    Screen screen{makeSdlContext(window), {}, "window"};
    screen.open = [] {
      bool open = true;
      for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
        const bool escape = event.type == SDL_KEYDOWN && event.key.keysym.scancode == SDL_SCANCODE_ESCAPE;
        open = open && event.type != SDL_QUIT && !escape;
      }
      return open;
    };
    return screen;
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
}

}  // namespace gw::profile
