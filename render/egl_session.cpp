#include "render/egl_session.h"

// EGL's headers pull X11 in unless told not to, and with it macros such as None and Success.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <utility>

namespace gw {
namespace {

template <class Function>
Function eglFunction(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::string_view textOf(const char* text) {
  return text == nullptr ? std::string_view() : std::string_view(text);
}

EglPlatform describe(EGLDeviceEXT device) {
  EglPlatform platform;
  platform.device = device;
  if (const auto queryString = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT")) {
    platform.place.extensions = textOf(queryString(device, EGL_EXTENSIONS));
  }
  // To ask a device that does not know the attribute would be an error.
  const auto queryAttribute = eglFunction<PFNEGLQUERYDEVICEATTRIBEXTPROC>("eglQueryDeviceAttribEXT");
  if (queryAttribute != nullptr && hasExtension(platform.place.extensions, "EGL_NV_device_cuda")) {
    EGLAttrib ordinal = 0;
    if (queryAttribute(device, EGL_CUDA_DEVICE_NV, &ordinal)) platform.place.cudaOrdinal = int(ordinal);
  }
  return platform;
}

}  // namespace

std::vector<EglPlatform> listEglPlatforms() {
  std::vector<EglPlatform> platforms;
  const std::string_view client = textOf(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS));
  if (hasExtension(client, "EGL_MESA_platform_surfaceless")) {
    platforms.emplace_back();
    platforms.back().place.surfaceless = true;
  }
  const auto queryDevices = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (queryDevices == nullptr || !hasExtension(client, "EGL_EXT_platform_device")) return platforms;
  EGLint count = 0;
  if (!queryDevices(0, nullptr, &count) || count <= 0) return platforms;
  std::vector<EGLDeviceEXT> devices(size_t(count), nullptr);
  if (!queryDevices(count, devices.data(), &count)) return platforms;
  devices.resize(size_t(count));
  for (EGLDeviceEXT device : devices) platforms.push_back(describe(device));
  return platforms;
}

std::optional<EglSession> EglSession::open(const EglPlatform& platform) {
  EGLDisplay display = platform.place.surfaceless
                           ? eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                           : eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, platform.device, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return std::nullopt;
  if (!hasExtension(textOf(eglQueryString(display, EGL_EXTENSIONS)), "EGL_KHR_surfaceless_context"))
    return std::nullopt;
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

EglSession::EglSession(EglSession&& other) noexcept
    : display_(std::exchange(other.display_, EGL_NO_DISPLAY)),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}

EglSession::~EglSession() {
  if (context_ == EGL_NO_CONTEXT) return;
  if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

bool EglSession::makeCurrent() const {
  return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

std::optional<EglPlatform> EglSession::device() const {
  const auto queryDisplay = eglFunction<PFNEGLQUERYDISPLAYATTRIBEXTPROC>("eglQueryDisplayAttribEXT");
  EGLAttrib device = 0;
  if (queryDisplay == nullptr || !queryDisplay(display_, EGL_DEVICE_EXT, &device) || device == 0) return std::nullopt;
  return describe(reinterpret_cast<EGLDeviceEXT>(device));
}

}  // namespace gw
