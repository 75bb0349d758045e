// toml++ with one set of switches for every file that parses: headers compiled with different ones must not meet.
#pragma once

// Nested values are counted by toml++; nested dotted keys are bounded by whoever bounds the lines. Together they
// bound the recursion of parsing and destruction, whatever text comes along.
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#define TOML_MAX_NESTED_VALUES 16
#define TOML_ENABLE_FORMATTERS 1
#include <toml++/toml.h>
