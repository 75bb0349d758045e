#include "render/gl_renderers.h"

#include <GL/glew.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

#include "render/egl_session.h"

namespace gw {
namespace {

// Drivers write straight to the file descriptor, each in its own way.
class QuietStderr {
 public:
  QuietStderr() {
    std::fflush(stderr);
    kept_ = dup(STDERR_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietStderr() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  int kept_ = -1;
};

std::string textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

}  // namespace

std::vector<GlRenderer> listGlRenderers() {
  const QuietStderr quiet;
  std::vector<GlRenderer> renderers;
  int devices = 0;
  for (const EglPlatform& platform : listEglPlatforms()) {
    GlRenderer renderer;
    renderer.place = platform.place.surfaceless ? "surfaceless" : "device " + std::to_string(devices++);
    renderer.software = platform.place.software();
    if (const auto session = EglSession::open(platform)) {
      renderer.name = textOf(GL_RENDERER) + ", OpenGL " + textOf(GL_VERSION);
      const EglPlatform device = session->device().value_or(platform);
      renderer.software = device.place.software();
      renderer.cudaDevice = device.place.cudaOrdinal;
    }
    renderers.push_back(std::move(renderer));
  }
  return renderers;
}

}  // namespace gw
