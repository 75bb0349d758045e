#define TOML_IMPLEMENTATION

#include "host/platform/toml_library.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "host/platform/utf8_text.h"

namespace gw {
namespace {

// toml++ up to 3.4 takes for unreachable what most characters from U+00A0 to U+FEFF reach where it looks for white
// space ("1é"; a line of a text that goes on behind "\"). None of them means anything to TOML itself, so they are moved
// to where toml++ has nothing to say about them, and what comes out of it is moved back.
constexpr char32_t kFirst = 0xA0, kLast = 0xFEFF, kMovedBy = 0xF0000;  // into plane 15, for private use

// The text with each character for which replaced(code point, its place) is not 0 replaced by that. Bytes that are not
// UTF-8 stay, for toml++ to refuse.
template <class Replaced>
std::string withCharacters(std::string_view text, const Replaced& replaced) {
  std::string result;
  result.reserve(text.size());
  eachCharacter(text, [&](char32_t code, std::string_view bytes) {
    const char32_t other = code == kInvalidByte ? 0 : replaced(code, size_t(bytes.data() - text.data()));
    other ? void(utf8::append(other, std::back_inserter(result))) : void(result += bytes);
  });
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
