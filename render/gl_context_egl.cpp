#include "render/gl_context_egl.h"

#include <GL/glew.h>
// EGL's headers pull X11 in unless told not to, and with it macros such as None and Success.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "render/gl_objects.h"

namespace gw {
namespace {

// One initialised display with a context on it; both go with it.
class EglSession {
 public:
  EglSession(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  EglSession(EglSession&& other) noexcept
      : display_(std::exchange(other.display_, EGL_NO_DISPLAY)),
        context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}
  EglSession& operator=(EglSession&&) = delete;
  ~EglSession() {
    // The display itself is shared by everyone in the process who asked for it: only the context is ours.
    if (context_ == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }

  bool makeCurrent() const { return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

bool hasExtension(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

// A current 4.5 core context on the display, or nothing.
std::optional<EglSession> tryDisplay(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return std::nullopt;
  if (!hasExtension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) return std::nullopt;
  if (!eglBindAPI(EGL_OPENGL_API)) return std::nullopt;

  // Surface type 0: a device platform without a screen offers no window configurations at all.
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return std::nullopt;

  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return std::nullopt;
  EglSession session(display, context);
  if (!session.makeCurrent()) return std::nullopt;
  return session;
}

EglSession openEgl() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (hasExtension(client, "EGL_MESA_platform_surfaceless")) {
    if (auto session = tryDisplay(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr))) {
      return std::move(*session);
    }
  }
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  if (queryDevices != nullptr && hasExtension(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (queryDevices(16, devices, &count)) {
      for (EGLint i = 0; i < count; ++i) {
        if (auto session = tryDisplay(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr))) {
          return std::move(*session);
        }
      }
    }
  }
  throw std::runtime_error(
      "No OpenGL 4.5 without a display here: install the graphics driver's EGL library (or Mesa's libegl-mesa0 and "
      "libgl1-mesa-dri), or use a verb that draws nothing.");
}

class EglContext final : public GlContext {
 public:
  explicit EglContext(PixelSize size) : session_(openEgl()), size_(size) {
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

std::unique_ptr<GlContext> makeEglContext(PixelSize size) {
  return std::make_unique<EglContext>(size);
}

}  // namespace gw
