// A current OpenGL 4.5 core context and the picture it draws into. A window (gl_context_sdl.h) and the
// headless one (gl_context_egl.h) differ in nothing else.
#pragma once

#include <string>

namespace gw {

struct PixelSize {
  int width = 0, height = 0;
};

class GlContext {
 public:
  virtual ~GlContext() = default;

  // Makes the context current on the calling thread.
  virtual void makeCurrent() = 0;

  // Binds the picture to draw into and sets the viewport to all of it. Once per frame, before the passes.
  virtual void bindTarget() = 0;

  // Shows the frame. Headless: waits until the GPU has drawn it, so that timing a frame means something.
  virtual void swap() = 0;

  // Of the picture, in pixels; a window's may change between frames.
  virtual PixelSize size() const = 0;

  // What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6".
  std::string rendererName() const;

 protected:
  // Loads the functions of the context that was just made current and checks that it is 4.5. Throws a
  // std::runtime_error that a player can act on. Debug builds also report every GL error as it happens.
  static void loadFunctions();
};

}  // namespace gw
