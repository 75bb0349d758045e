#include "game/ui/format.h"

#include <cstdio>

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
  char text[24];
  std::snprintf(text, sizeof text, "%u:%02u", seconds / 60, seconds % 60);
  return text;
}

std::string minutesTenths(uint32_t ticks) {
  return minutesSeconds(ticks) + "." + std::to_string(ticks % kTicksPerSecond * 10 / kTicksPerSecond);
}

std::string oneDecimal(double number) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f", number);
  return text;
}

std::string twoDecimals(double number) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2f", number);
  return text;
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
