// Where a headless context is best opened: the choice alone, which needs no EGL (render/egl_session.h makes the calls).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw {

// One place that may give a context.
struct EglPlace {
  bool surfaceless = false;        // Mesa's platform without a device; else a device that EGL lists
  std::string extensions;          // of the device
  std::optional<int> cudaOrdinal;  // EGL_CUDA_DEVICE_NV: the CUDA device that this one is

  bool software() const;
};

// Whole words: one extension's name may begin another's.
bool hasExtension(std::string_view extensions, std::string_view name);

// Whether a processor draws, by what OpenGL calls its renderer: not every such device has EGL's extension for it.
bool softwareRenderer(std::string_view name);

// The places in the order in which to try them. When CUDA computes, its own device comes first, for only there frames
// stay on the GPU. Then the surfaceless platform, then devices as EGL lists them: beside an NVIDIA GPU the surfaceless
// platform may give Mesa, or nothing.
std::vector<size_t> eglOrder(const std::vector<EglPlace>& places, std::optional<int> cudaDevice);

}  // namespace gw
