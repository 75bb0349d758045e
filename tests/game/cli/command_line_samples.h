// Command lines as one string, and what is expected of those that are refused.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "game/cli/command_line.h"

namespace gw::test {

// Words are separated by spaces.
ParsedCommandLine parse(const std::string& line);

// The options of a line that is accepted, for the verb whose they are.
template <class Options>
Options optionsOf(const ParsedCommandLine& parsed) {
  EXPECT_TRUE(parsed.run) << parsed.error;
  EXPECT_EQ(parsed.error, "");
  const auto* options = std::get_if<Options>(&parsed.options);
  EXPECT_NE(options, nullptr) << "another verb than " << Options::kName;
  return options != nullptr ? *options : Options();
}

template <class Options>
Options accepted(const std::string& line) {
  SCOPED_TRACE(line);
  return optionsOf<Options>(parse(line));
}

struct Refusal {
  const char* line;
  const char* error;  // all of it
};

// A refused line is one sentence and exit code 2.
class CommandLineRefusal : public ::testing::TestWithParam<Refusal> {};

}  // namespace gw::test
