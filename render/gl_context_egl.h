// OpenGL without a window or a display server: for headless runs, profiles, films and tests.
#pragma once

#include <memory>
#include <optional>

#include "render/gl_context.h"

namespace gw {

// Draws into a frame buffer of its own, of this size. When a CUDA device computes, say which: then the context is on
// that GPU if EGL offers it. Else on the surfaceless platform, else on the first device that gives a 4.5 core
// context. Throws std::runtime_error when there is none.
std::unique_ptr<GlContext> makeEglContext(PixelSize size, std::optional<int> cudaDevice = {});

}  // namespace gw
