// The characters of a text that should be UTF-8 but may hold any bytes, as names of files do.
#pragma once

#include <utf8.h>

#include <string_view>

namespace gw {

// Not a code point: the byte is not part of a valid character.
inline constexpr char32_t kInvalidByte = 0xFFFFFFFF;

// Calls visit(code point, its bytes) for each character, and visit(kInvalidByte, the byte) for each other byte.
template <class Visit>
void eachCharacter(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const char* const begin = text.data();
    const char* const valid = utf8::find_invalid(begin, begin + text.size());
    for (const char* at = begin; at != valid;) {
      const char* const start = at;
      const char32_t code = utf8::unchecked::next(at);
      visit(code, std::string_view(start, size_t(at - start)));
    }
    text.remove_prefix(size_t(valid - begin));
    if (text.empty()) return;
    visit(kInvalidByte, text.substr(0, 1));
    text.remove_prefix(1);
  }
}

}  // namespace gw
