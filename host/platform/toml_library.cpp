#define TOML_IMPLEMENTATION

#include "host/platform/toml_library.h"

#include <algorithm>
#include <vector>

namespace gw {
namespace {

// toml++ up to 3.4 takes for unreachable what most characters from U+00A0 to U+FEFF reach where it looks for white
// space ("1é"; a line of a text that goes on behind "\"). None of them means anything to TOML itself, so they are moved
// to where toml++ has nothing to say about them, and what comes out of it is moved back.
constexpr char32_t kFirst = 0xA0, kLast = 0xFEFF, kMovedBy = 0xF0000;  // into plane 15, for private use

// A character of UTF-8: how many bytes it has; 0: these are none, or one of ASCII.
struct Character {
  char32_t code = 0;
  size_t size = 0;
};

Character characterAt(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return at + i < text.size() ? uint8_t(text[at + i]) : uint8_t(0); };
  const size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 0;
  if (size == 0 || byte(0) > 0xF4) return {};
  char32_t code = byte(0) & (0x7Fu >> size);
  for (size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  const char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < least[size] || surrogate ? Character{} : Character{code, size};
}

void append(std::string& text, char32_t code) {
  const auto tail = [&](int shift) { text += char(0x80u | ((code >> shift) & 0x3Fu)); };
  if (code >= 0x10000) {
    text += char(0xF0u | (code >> 18));
    tail(12);
    tail(6);
  } else if (code >= 0x800) {
    text += char(0xE0u | (code >> 12));
    tail(6);
  } else {
    text += char(0xC0u | (code >> 6));
  }
  tail(0);
}

// Bytes that are no UTF-8 stay, for toml++ to refuse. What `replaced` returns 0 for stays too.
template <class Replaced>
std::string withCharacters(std::string_view text, const Replaced& replaced) {
  std::string result;
  result.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const Character character = characterAt(text, i);
    const char32_t other = character.size > 0 ? replaced(character.code, i) : 0;
    const size_t size = std::max<size_t>(1, character.size);
    other ? append(result, other) : void(result += text.substr(i, size));
    i += size;
  }
  return result;
}

std::string movedAway(std::string_view text) {
  return withCharacters(text, [&](char32_t code, size_t at) -> char32_t {
    if (code >= kFirst + kMovedBy && code <= kLast + kMovedBy) {
      const auto line = uint32_t(1 + std::count(text.begin(), text.begin() + ptrdiff_t(at), '\n'));
      throw TomlError(line, "a character for private use, from U+F0000 on");
    }
    const bool byteOrderMark = code == kLast && at == 0;
    return code >= kFirst && code <= kLast && !byteOrderMark ? code + kMovedBy : 0;
  });
}

std::string movedBack(std::string_view text) {
  return withCharacters(text, [](char32_t code, size_t) -> char32_t {
    return code >= kFirst + kMovedBy && code <= kLast + kMovedBy ? code - kMovedBy : 0;
  });
}

void moveBack(toml::table& table);

void moveBack(toml::node& node) {
  if (auto* text = node.as_string()) text->get() = movedBack(text->get());
  if (auto* list = node.as_array()) {
    for (toml::node& item : *list) moveBack(item);
  }
  if (auto* table = node.as_table()) moveBack(*table);
}

void moveBack(toml::table& table) {
  std::vector<toml::key> moved;
  for (auto&& [key, node] : table) {
    moveBack(node);
    if (movedBack(key.str()) != key.str()) moved.push_back(key);
  }
  for (const toml::key& key : moved) {
    const std::string own = movedBack(key.str());
    if (table.contains(own)) throw TomlError(key.source().begin.line, "the key '" + own + "' stands there twice");
    table.insert_or_assign(toml::key(own, key.source()), std::move(*table.get(key.str())));
    table.erase(key.str());
  }
}

}  // namespace

toml::table parseToml(std::string_view text) {
  const std::string safe = movedAway(text);
  try {
    toml::table document = toml::parse(std::string_view(safe));
    if (safe != text) moveBack(document);
    return document;
  } catch (const toml::parse_error& error) {
    throw TomlError(std::max<uint32_t>(1, error.source().begin.line), movedBack(error.description()));
  }
}

}  // namespace gw
