// Everything that could draw without a display here, for `gpuwars devices`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gw {

struct GlRenderer {
  std::string place;              // "surfaceless", or "device N" in EGL's order
  std::string name;               // e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 ..."; empty: no OpenGL 4.5 there
  bool software = false;          // a processor draws
  std::optional<int> cudaDevice;  // the CUDA device that it shares memory with
};

// Opens a context at each place and closes it again; none is current afterwards. Empty where EGL has no driver.
// Drivers' own remarks on the way are kept off stderr: that a place gives nothing is an answer here. Never throws.
std::vector<GlRenderer> listGlRenderers();

}  // namespace gw
