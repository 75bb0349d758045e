#include "render/gl_context_sdl.h"

#include <GL/glew.h>
#include <SDL.h>

#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "render/gl_environment.h"
#include "render/sdl_error.h"

namespace gw {
namespace {

constexpr const char* kDesktop = "start GpuWars in a desktop session with an up-to-date graphics driver";

std::runtime_error displayError(const char* what, const std::string& remedy = kDesktop) {
  return std::runtime_error(what + sdlReason() + ": " + remedy + ", or run with --headless.");
}

// SDL counts how often its video was started, so that this ends only what it began.
class SdlVideo {
 public:
  SdlVideo() {
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) throw displayError("No display to open a window on");
    // Without a display SDL quietly takes a driver whose windows are not shown. Tests ask for it by name.
    if (std::strcmp(SDL_GetCurrentVideoDriver(), "offscreen") == 0 && std::getenv("SDL_VIDEODRIVER") == nullptr) {
      SDL_QuitSubSystem(SDL_INIT_VIDEO);
      SDL_SetError("neither X nor Wayland answers");
      throw displayError("No display to open a window on");
    }
  }
  ~SdlVideo() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }
  SdlVideo(const SdlVideo&) = delete;
  SdlVideo& operator=(const SdlVideo&) = delete;
};

struct DestroyWindow {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
};
struct DeleteContext {
  void operator()(void* context) const { SDL_GL_DeleteContext(context); }
};

class SdlContextImpl final : public SdlContext {
 public:
  explicit SdlContextImpl(const WindowOptions& options) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 5);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
#ifndef NDEBUG
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_DEBUG_FLAG);
#endif
    // No SDL_WINDOW_ALLOW_HIGHDPI: four times the pixels would show the same shapes, and llvmpipe pays for each.
    Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE;
    if (options.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    window_.reset(SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   options.size.width, options.size.height, flags));
    if (!window_) throw displayError("No window with OpenGL could be opened", glRemedy(kDesktop));
    // No screen takes text, and an input method that waits for some would keep the letters to itself.
    SDL_StopTextInput();
    SDL_SetWindowMinimumSize(window_.get(), 320, 180);
    context_.reset(SDL_GL_CreateContext(window_.get()));
    if (!context_) throw displayError("No OpenGL 4.5 on this display", glRemedy(kDesktop));
    makeCurrent();
    loadFunctions();
    // -1 waits only when the frame is in time; drivers that do not know it take 1, or nothing at all.
    verticalSync_ = options.verticalSync && (SDL_GL_SetSwapInterval(-1) == 0 || SDL_GL_SetSwapInterval(1) == 0);
    if (!verticalSync_) SDL_GL_SetSwapInterval(0);
    bindTarget();
  }

  void makeCurrent() override {
    if (SDL_GL_MakeCurrent(window_.get(), context_.get()) != 0) throw displayError("The window's OpenGL was lost");
  }

  void bindTarget() override {
    const PixelSize now = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, now.width, now.height);
  }

  void swap() override {
    SDL_GL_SwapWindow(window_.get());
  }

  PixelSize size() const override {
    PixelSize size;
    SDL_GL_GetDrawableSize(window_.get(), &size.width, &size.height);
    return size;
  }

  SDL_Window* window() const override {
    return window_.get();
  }

  void setFullscreen(bool on) override {
    SDL_SetWindowFullscreen(window_.get(), on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
  }

  bool fullscreen() const override {
    return is(SDL_WINDOW_FULLSCREEN);
  }

  bool hidden() const override {
    return is(SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
  }

  void keepPointer(bool on) override {
    SDL_SetWindowMouseGrab(window_.get(), on ? SDL_TRUE : SDL_FALSE);
  }

  double screenRate() const override {
    SDL_DisplayMode mode{};
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    return display >= 0 && SDL_GetCurrentDisplayMode(display, &mode) == 0 ? mode.refresh_rate : 0;
  }

  bool verticalSync() const override {
    return verticalSync_;
  }

 private:
  bool is(Uint32 anyOf) const {
    return (SDL_GetWindowFlags(window_.get()) & anyOf) != 0;
  }

  SdlVideo video_;
  std::unique_ptr<SDL_Window, DestroyWindow> window_;
  std::unique_ptr<void, DeleteContext> context_;
  bool verticalSync_ = false;
};

}  // namespace

std::unique_ptr<SdlContext> makeSdlContext(const WindowOptions& options) {
  return std::make_unique<SdlContextImpl>(options);
}

}  // namespace gw
