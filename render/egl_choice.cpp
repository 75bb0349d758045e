#include "render/egl_choice.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace gw {

bool hasExtension(std::string_view extensions, std::string_view name) {
  while (!extensions.empty()) {
    const size_t end = std::min(extensions.find(' '), extensions.size());
    if (extensions.substr(0, end) == name) return true;
    extensions.remove_prefix(std::min(end + 1, extensions.size()));
  }
  return false;
}

bool EglPlace::software() const {
  return hasExtension(extensions, "EGL_MESA_device_software");
}

bool softwareRenderer(std::string_view name) {
  constexpr std::string_view kNames[] = {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer", "SwiftShader"};
  return std::any_of(std::begin(kNames), std::end(kNames),
                     [&](std::string_view part) { return name.find(part) != name.npos; });
}

std::vector<size_t> eglOrder(const std::vector<EglPlace>& places, std::optional<int> cudaDevice) {
  std::vector<size_t> order(places.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto rank = [&](size_t i) {
    if (cudaDevice && places[i].cudaOrdinal == cudaDevice) return 0;
    return places[i].surfaceless ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return rank(a) < rank(b); });
  return order;
}

}  // namespace gw
