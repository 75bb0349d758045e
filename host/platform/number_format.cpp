#include "host/platform/number_format.h"

#include <fmt/format.h>

namespace gw {

std::string withCommas(uint64_t number) {
  return groupThousands(std::to_string(number));
}

std::string groupThousands(std::string whole) {
  const size_t first = whole.starts_with('-') ? 1 : 0;
  for (size_t at = whole.size(); at > first + 3;) whole.insert(at -= 3, 1, ',');
  return whole;
}

std::string oneDecimal(double number) {
  return fmt::format("{:.1f}", number);
}

std::string twoDecimals(double number) {
  return fmt::format("{:.2f}", number);
}

std::string hexadecimal(uint64_t number) {
  return fmt::format("{:016x}", number);
}

std::string upperCase(std::string text) {
  for (char& character : text) {
    if (character >= 'a' && character <= 'z') character = char(character - 'a' + 'A');
  }
  return text;
}

}  // namespace gw
