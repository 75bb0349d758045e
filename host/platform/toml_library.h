// toml++ with one set of switches for every file that parses, through its public header alone: its code is compiled
// once, in toml_library.cpp.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

// Nested values are counted by toml++; nested dotted keys are bounded by the caller, who bounds the lines. Together
// they bound the recursion of parsing and destruction, whatever text comes along.
#define TOML_HEADER_ONLY 0
#define TOML_EXCEPTIONS 1
#define TOML_MAX_NESTED_VALUES 16
#define TOML_ENABLE_FORMATTERS 1

// Some of its assertions are about the text, not about its caller, and the parser says what is wrong right behind them
// ("[?" is one). A user's text must neither abort a debug build nor be undefined behaviour in others: where NDEBUG is
// set, toml++ turns them into assumptions of the optimiser. So it sees no NDEBUG here, and asserts nothing.
#define TOML_ASSERT(expression) static_cast<void>(0)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace gw {

struct TomlError : std::runtime_error {
  TomlError(uint32_t errorLine, const std::string& what) : std::runtime_error(what), line(errorLine) {}
  uint32_t line;  // from 1
};

// The document of a text. Throws TomlError, and nothing else of toml++'s.
toml::table parseToml(std::string_view text);

}  // namespace gw
