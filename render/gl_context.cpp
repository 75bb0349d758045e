#include "render/gl_context.h"

#include <GL/glew.h>

#include <cstdio>
#include <stdexcept>

namespace gw {
namespace {

// GLEW built for GLX reports this when there is no X display (EGL, Wayland); every function is loaded by then.
constexpr GLenum kNoGlxDisplay = 4;

#ifndef NDEBUG
void GLAPIENTRY reportGlMessage(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void*) {
  if (type == GL_DEBUG_TYPE_ERROR) std::fprintf(stderr, "OpenGL: %s\n", message);
}
#endif

const char* textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

void GlContext::loadFunctions() {
  glewExperimental = GL_TRUE;  // core contexts have no extension string for GLEW to look functions up in
  const GLenum result = glewInit();
  if (result != GLEW_OK && result != kNoGlxDisplay) {
    throw std::runtime_error(std::string("The OpenGL functions could not be loaded (") +
                             reinterpret_cast<const char*>(glewGetErrorString(result)) +
                             "): install or update the graphics driver, or run with --headless.");
  }
  if (!GLEW_VERSION_4_5) {
    throw std::runtime_error(std::string("No OpenGL 4.5 here, only ") + textOf(GL_VERSION) +
                             ": update the graphics driver (Mesa's libgl1-mesa-dri will do), or run with --headless.");
  }
  glGetError();  // glewInit may leave one behind that is not ours
#ifndef NDEBUG
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(reportGlMessage, nullptr);
#endif
}

std::string GlContext::rendererName() const {
  return std::string(textOf(GL_RENDERER)) + ", OpenGL " + textOf(GL_VERSION);
}

}  // namespace gw
