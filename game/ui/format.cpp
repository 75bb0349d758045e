#include "game/ui/format.h"

#include <fmt/format.h>

#include "game/sim/rules.h"

namespace gw {

std::string withCommas(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

std::string minutesSeconds(uint32_t ticks) {
  const uint32_t seconds = ticks / kTicksPerSecond;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string minutesTenths(uint32_t ticks) {
  return minutesSeconds(ticks) + "." + std::to_string(ticks % kTicksPerSecond * 10 / kTicksPerSecond);
}

std::string oneDecimal(double number) {
  return fmt::format("{:.1f}", number);
}

std::string twoDecimals(double number) {
  return fmt::format("{:.2f}", number);
}

std::string multiplierText(uint32_t tenths) {
  std::string text(1, 'x');
  text += withCommas(tenths / 10);
  text += '.';
  return text += std::to_string(tenths % 10);
}

std::string upperCase(std::string text) {
  for (char& character : text) {
    if (character >= 'a' && character <= 'z') character = char(character - 'a' + 'A');
  }
  return text;
}

double framesPerSecond(uint32_t frameTime_us) {
  return frameTime_us == 0 ? 0 : 1e6 / frameTime_us;
}

}  // namespace gw
