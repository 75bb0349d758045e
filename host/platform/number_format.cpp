#include "host/platform/number_format.h"

#include <fmt/format.h>

namespace gw {

std::string withCommas(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

std::string oneDecimal(double number) {
  return fmt::format("{:.1f}", number);
}

std::string twoDecimals(double number) {
  return fmt::format("{:.2f}", number);
}

std::string upperCase(std::string text) {
  for (char& character : text) {
    if (character >= 'a' && character <= 'z') character = char(character - 'a' + 'A');
  }
  return text;
}

}  // namespace gw
