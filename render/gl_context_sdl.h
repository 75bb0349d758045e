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

  // Asks for it. Whether it happens, and when, is up to the window manager: fullscreen() tells.
  virtual void setFullscreen(bool on) = 0;
  virtual bool fullscreen() const = 0;

  // Minimised or hidden: a picture would not be seen.
  virtual bool hidden() const = 0;

  // The pointer cannot leave the window while it has the focus.
  virtual void keepPointer(bool on) = 0;

  // Frames a second of the screen that the window is on; 0: not known.
  virtual double screenRate() const = 0;

  // Whether the driver has agreed that swap() waits for the screen.
  virtual bool verticalSync() const = 0;
};

// Starts SDL's video unless it is running. Throws std::runtime_error when there is no display or no OpenGL 4.5.
std::unique_ptr<SdlContext> makeSdlContext(const WindowOptions& options);

}  // namespace gw
