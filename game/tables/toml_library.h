// toml++ with one set of switches for every file that parses: headers compiled with different ones must not meet.
#pragma once

// Nested values are counted by toml++; nested dotted keys are bounded by whoever bounds the lines. Together they
// bound the recursion of parsing and destruction, whatever text comes along.
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#define TOML_MAX_NESTED_VALUES 16
#define TOML_ENABLE_FORMATTERS 1

// Some of its assertions are about the text, not about its caller, and the parser says what is wrong right behind them
// ("[?" is one). A user's text must neither abort a debug build nor be undefined behaviour in one of clang's, where
// they become __builtin_assume: they are taken out, as they are of g++'s release builds.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_ASSERT_ASSUME(expression) static_assert(true)

#include <toml++/toml.h>
