#include "game/ui/tick_text.h"

#include <fmt/format.h>

#include "game/sim/rules.h"
#include "host/platform/number_format.h"

namespace gw {

std::string minutesSeconds(uint32_t ticks) {
  const uint32_t seconds = ticks / kTicksPerSecond;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string minutesTenths(uint32_t ticks) {
  return minutesSeconds(ticks) + "." + std::to_string(ticks % kTicksPerSecond * 10 / kTicksPerSecond);
}

std::string multiplierText(uint32_t tenths) {
  std::string text(1, 'x');
  text += withCommas(tenths / 10);
  text += '.';
  return text += std::to_string(tenths % 10);
}

double framesPerSecond(uint32_t frameTime_us) {
  return frameTime_us == 0 ? 0 : 1e6 / frameTime_us;
}

}  // namespace gw
