#include "render/gl_renderers.h"

#include <GL/glew.h>

#include "render/egl_session.h"
#include "render/quiet_stderr.h"

namespace gw {
namespace {

std::string textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

}  // namespace

std::vector<GlRenderer> listGlRenderers() {
  const QuietStderr quiet;  // drivers write straight to the file descriptor, each in its own way
  std::vector<GlRenderer> renderers;
  int devices = 0;
  for (const EglPlatform& platform : listEglPlatforms()) {
    GlRenderer renderer;
    renderer.place = platform.place.surfaceless ? "surfaceless" : "device " + std::to_string(devices++);
    renderer.software = platform.place.software();
    if (const auto session = EglSession::open(platform)) {
      renderer.name = textOf(GL_RENDERER) + ", OpenGL " + textOf(GL_VERSION);
      const EglPlatform device = session->device().value_or(platform);
      renderer.software = device.place.software() || softwareRenderer(textOf(GL_RENDERER));
      renderer.cudaDevice = device.place.cudaOrdinal;
    }
    renderers.push_back(std::move(renderer));
  }
  return renderers;
}

}  // namespace gw
