// OpenGL in an SDL2 window. Only in builds with GW_WINDOW.
#pragma once

#include <memory>
#include <string>

#include "render/gl_context.h"

struct SDL_Window;

namespace gw {

struct WindowOptions {
  std::string title = "GpuWars";
  PixelSize size{1280, 720};
  bool fullscreen = false;  // the desktop's own resolution, without changing it
  bool verticalSync = true;
};

class SdlContext : public GlContext {
 public:
  // For events and for where the mouse is.
  virtual SDL_Window* window() const = 0;

  virtual void setFullscreen(bool on) = 0;

  // Whether swap() really waits for the screen: drivers may refuse, and the game then limits its frames itself.
  virtual bool verticalSync() const = 0;
};

// Starts SDL's video when nobody has. Throws std::runtime_error when there is no display or no OpenGL 4.5.
std::unique_ptr<SdlContext> makeSdlContext(const WindowOptions& options);

}  // namespace gw
