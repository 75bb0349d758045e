#include "render/gl_environment.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace gw {
namespace {

constexpr const char* kVariables[] = {
    "__EGL_VENDOR_LIBRARY_FILENAMES",
    "__EGL_VENDOR_LIBRARY_DIRS",
    "__GLX_VENDOR_LIBRARY_NAME",
    "__NV_PRIME_RENDER_OFFLOAD",
    "DRI_PRIME",
    "EGL_PLATFORM",
    "GALLIUM_DRIVER",
    "GBM_BACKEND",
    "GBM_BACKENDS_PATH",
    "LIBGL_ALWAYS_INDIRECT",
    "LIBGL_ALWAYS_SOFTWARE",
    "LIBGL_DRIVERS_PATH",
    "MESA_EXTENSION_OVERRIDE",
    "MESA_GLSL_VERSION_OVERRIDE",
    "MESA_GL_VERSION_OVERRIDE",
    "MESA_LOADER_DRIVER_OVERRIDE",
    "VK_DRIVER_FILES",
    "VK_ICD_FILENAMES",
};

// A sentence is one line, and a value may be long or hold anything.
std::string shown(std::string value) {
  constexpr size_t kMost = 60;
  if (value.size() > kMost) value = value.substr(0, kMost) + "...";
  std::replace_if(
      value.begin(), value.end(), [](unsigned char c) { return c < ' '; }, '?');
  return "'" + value + "'";
}

}  // namespace

const char* processEnvironment(const char* name) {
  return std::getenv(name);
}

std::string glRemedy(const std::string& otherwise, const Environment& environment) {
  std::vector<std::string> set;
  for (const char* name : kVariables) {
    if (const char* value = environment(name)) set.push_back(std::string(name) + "=" + shown(value));
  }
  if (set.empty()) return otherwise;
  std::string all;
  for (size_t i = 0; i < set.size(); ++i) all += (i == 0 ? "" : i + 1 == set.size() ? " and " : ", ") + set[i];
  return set.size() == 1 ? "the environment has " + all + ", the likely cause: unset it"
                         : "the environment has " + all + ", one of them the likely cause: unset them";
}

}  // namespace gw
