#include "host/platform/markup_text.h"

#include <cstdint>

namespace gw::profile {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// Bytes of the character at the start of `text`, 0 when there is none that XML allows.
size_t characterAt(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : 0u; };
  const uint32_t first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\n' || first == '\t' ? 1 : 0;
  const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  uint32_t code = first & (0xFFu >> (length + 1));
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  const bool control = code < 0xA0 || code == 0xFFFE || code == 0xFFFF;
  return code >= kLeast[length] && code <= 0x10FFFF && !surrogate && !control ? length : 0;
}

// Calls visit(character) for each, U+FFFD for what is none.
template <class Visit>
void eachCharacter(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const size_t length = characterAt(text);
    visit(length == 0 ? kReplacement : text.substr(0, length));
    text.remove_prefix(length == 0 ? 1 : length);
  }
}

}  // namespace

std::string xmlEscaped(std::string_view text) {
  std::string xml;
  eachCharacter(text, [&](std::string_view character) {
    switch (character[0]) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      case '\'':
        xml += "&#39;";
        break;
      default:
        xml += character;
    }
  });
  return xml;
}

std::string shortened(std::string_view text, size_t characters) {
  if (lengthOf(text) <= characters) return std::string(text);
  std::string start;
  size_t taken = 0;
  eachCharacter(text, [&](std::string_view character) {
    if (++taken < characters) start += character;
  });
  return start + "…";
}

size_t lengthOf(std::string_view text) {
  size_t length = 0;
  eachCharacter(text, [&](std::string_view) { ++length; });
  return length;
}

}  // namespace gw::profile
