#include "game/app/game_window.h"

#include <SDL.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "game/ui/canvas.h"
#include "host/platform/clock.h"
#include "host/platform/user_error.h"
#include "host/platform/window_display.h"

namespace gw {

GameWindow::GameWindow(const WindowOptions& options) {
  chooseDisplay();
  try {
    context_ = makeSdlContext(options);
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
  if (options.fullscreen) fullscreen_.ask(true, now_s());
}

EventArea GameWindow::eventArea() const {
  int width = 1, height = 1;
  SDL_GetWindowSize(context_->window(), &width, &height);
  return {float(width), float(height)};
}

float GameWindow::aspect() const {
  const PixelSize size = context_->size();
  return float(std::max(size.width, 1)) / float(std::max(size.height, 1));
}

float GameWindow::canvasWidth() const {
  return Canvas::kHeight * aspect();
}

CanvasPoint GameWindow::toCanvas(float x_px, float y_px) const {
  const float scale = Canvas::kHeight / std::max(eventArea().height, 1.0f);
  return {x_px * scale, y_px * scale};
}

void GameWindow::setFullscreen(bool on) {
  context_->setFullscreen(on);
  fullscreen_.ask(on, now_s());
}

void GameWindow::checkFullscreen(double now_s) {
  if (!fullscreen_.look(context_->fullscreen(), now_s)) return;
  std::fprintf(stderr,
               "The window system did not switch full screen %s: it takes a window manager, or --width and "
               "--height of the screen.\n",
               fullscreen() ? "off" : "on");
}

void GameWindow::showCursor(bool on) {
  if (on != cursorShown_) SDL_ShowCursor(on ? SDL_ENABLE : SDL_DISABLE);
  cursorShown_ = on;
}

void GameWindow::keepPointer(bool on) {
  if (on != pointerKept_) context_->keepPointer(on);
  pointerKept_ = on;
}

}  // namespace gw
