// The window: full screen, cursor, and the conversion of its coordinates to those of the canvas.
#pragma once

#include <memory>

#include "game/app/fullscreen_switch.h"
#include "render/gl_context_sdl.h"

namespace gw {

struct CanvasPoint {
  float x = 0, y = 0;
};

// The window's size in the units of its events, which are not always pixels.
struct EventArea {
  float width = 1, height = 1;
};

class GameWindow {
 public:
  // Throws UserError when there is no display or no OpenGL 4.5.
  explicit GameWindow(const WindowOptions& options);

  SdlContext& context() { return *context_; }
  EventArea eventArea() const;
  float aspect() const;  // width over height
  float canvasWidth() const;
  CanvasPoint toCanvas(float x_px, float y_px) const;  // from the coordinates of events

  void setFullscreen(bool on);
  bool fullscreen() const { return fullscreen_.on(); }
  // Once per frame. Prints a sentence when the window system has not done what was requested.
  void checkFullscreen(double now_s);

  void showCursor(bool on);
  bool cursorShown() const { return cursorShown_; }
  // Confines the pointer to the window while it has the focus.
  void keepPointer(bool on);

 private:
  std::unique_ptr<SdlContext> context_;
  FullscreenSwitch fullscreen_;
  bool cursorShown_ = true, pointerKept_ = false;
};

}  // namespace gw
