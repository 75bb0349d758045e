// OpenGL without a window or a display server: for headless runs, profiles, films and tests.
#pragma once

#include <memory>

#include "render/gl_context.h"

namespace gw {

// Draws into a frame buffer of its own, of this size. Takes the surfaceless platform, else the first
// device that gives a 4.5 core context. Throws std::runtime_error when there is none.
std::unique_ptr<GlContext> makeEglContext(PixelSize size);

}  // namespace gw
