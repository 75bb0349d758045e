#include "game/replay_viewer/speeds.h"

#include <cmath>

#include "host/platform/number_format.h"

namespace gw {

std::string speedText(double speed) {
  for (const int part : {10, 4, 2}) {
    if (speed < 1 && std::abs(speed * part - 1) < 1e-9) return "x1/" + std::to_string(part);
  }
  return speed == std::floor(speed) ? "x" + std::to_string(int(speed)) : "x" + twoDecimals(speed);
}

}  // namespace gw
