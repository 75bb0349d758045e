#include "render/gl_context_egl.h"

#include <GL/glew.h>

#include <stdexcept>
#include <utility>

#include "render/egl_session.h"
#include "render/gl_environment.h"
#include "render/gl_objects.h"
#include "render/quiet_stderr.h"

namespace gw {
namespace {

EglSession openEgl(std::optional<int> cudaDevice) {
  const QuietStderr quiet;  // a driver that gives nothing says so in lines of its own; another may give what is needed
  const std::vector<EglPlatform> platforms = listEglPlatforms();
  std::vector<EglPlace> places;
  for (const EglPlatform& platform : platforms) places.push_back(platform.place);
  for (const size_t i : eglOrder(places, cudaDevice)) {
    if (auto session = EglSession::open(platforms[i])) return std::move(*session);
  }
  throw std::runtime_error("No OpenGL 4.5 without a display here: " +
                           glRemedy("install the graphics driver's EGL library (or Mesa's libegl-mesa0 and "
                                    "libgl1-mesa-dri)") +
                           ", or use a verb that draws nothing.");
}

class EglContext final : public GlContext {
 public:
  EglContext(PixelSize size, std::optional<int> cudaDevice) : session_(openEgl(cudaDevice)), size_(size) {
    loadFunctions();
    colour_ = makeGlTexture(size, GL_RGBA8, GL_RGBA, nullptr);
    framebuffer_ = makeGlFramebuffer(colour_);
    bindTarget();
  }

  ~EglContext() override {
    // The picture's own objects are deleted after this body, and that needs their context.
    session_.makeCurrent();
  }

  void makeCurrent() override {
    if (!session_.makeCurrent()) throw std::runtime_error("The headless OpenGL context was lost: start GpuWars again.");
  }

  void bindTarget() override {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glViewport(0, 0, size_.width, size_.height);
  }

  void swap() override { glFinish(); }

  PixelSize size() const override { return size_; }

 private:
  EglSession session_;  // first: the objects below go before it
  PixelSize size_;
  GlTexture colour_;
  GlFramebuffer framebuffer_;
};

}  // namespace

std::unique_ptr<GlContext> makeEglContext(PixelSize size, std::optional<int> cudaDevice) {
  return std::make_unique<EglContext>(size, cudaDevice);
}

}  // namespace gw
