#include "host/platform/markup_text.h"

#include "host/platform/utf8_text.h"

namespace gw::profile {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

bool allowedInXml(char32_t code) {
  if (code < 0x20) return code == '\n' || code == '\t';
  const bool control = code >= 0x80 && code < 0xA0;
  return code != kInvalidByte && !control && code != 0xFFFE && code != 0xFFFF;
}

// Calls visit(character) for each that XML allows, and visit(U+FFFD) for each byte of the others.
template <class Visit>
void eachXmlCharacter(std::string_view text, const Visit& visit) {
  eachCharacter(text, [&](char32_t code, std::string_view bytes) {
    if (allowedInXml(code)) return visit(bytes);
    for (size_t i = 0; i < bytes.size(); ++i) visit(kReplacement);
  });
}

std::string_view escaped(std::string_view character) {
  switch (character[0]) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return character;
  }
}

}  // namespace

std::string xmlCharacters(std::string_view text) {
  std::string characters;
  eachXmlCharacter(text, [&](std::string_view character) { characters += character; });
  return characters;
}

std::string xmlEscaped(std::string_view text) {
  std::string xml;
  eachXmlCharacter(text, [&](std::string_view character) { xml += escaped(character); });
  return xml;
}

std::string shortened(std::string_view text, size_t characters) {
  if (lengthOf(text) <= characters) return std::string(text);
  std::string start;
  size_t taken = 0;
  eachXmlCharacter(text, [&](std::string_view character) {
    if (++taken < characters) start += character;
  });
  return start + "…";
}

size_t lengthOf(std::string_view text) {
  size_t length = 0;
  eachXmlCharacter(text, [&](std::string_view) { ++length; });
  return length;
}

}  // namespace gw::profile
