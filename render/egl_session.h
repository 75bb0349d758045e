// What EGL has here, and contexts on it, without a display server.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/egl_choice.h"

namespace gw {

// EGL's handles are plain pointers; its headers stay out of ours, for they may bring X11's macros.
struct EglPlatform {
  EglPlace place;
  void* device = nullptr;  // EGLDeviceEXT; null: surfaceless
};

// The surfaceless platform first, then every device. Empty where EGL has no driver. Never throws.
std::vector<EglPlatform> listEglPlatforms();

// One OpenGL context; it goes with its owner. The display stays: everyone in the process who asks for it shares it.
class EglSession {
 public:
  // A current 4.5 core context there, or nothing.
  static std::optional<EglSession> open(const EglPlatform& platform);

  EglSession(EglSession&& other) noexcept;
  EglSession& operator=(EglSession&&) = delete;
  ~EglSession();

  bool makeCurrent() const;

  // The device behind the display, whichever way it was opened; nothing when EGL does not tell.
  std::optional<EglPlatform> device() const;

 private:
  EglSession(void* display, void* context) : display_(display), context_(context) {}

  void* display_;
  void* context_;
};

}  // namespace gw
