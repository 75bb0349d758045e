#include "tests/game/cli/command_line_samples.h"

#include <sstream>

namespace gw::test {

ParsedCommandLine parse(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return parseCommandLine(arguments);
}

TEST_P(CommandLineRefusal, IsOneSentenceAndExitCodeTwo) {
  const ParsedCommandLine parsed = parse(GetParam().line);
  EXPECT_FALSE(parsed.run);
  EXPECT_EQ(parsed.code, ExitCode::badUsage);
  EXPECT_EQ(parsed.error, GetParam().error);
  EXPECT_EQ(parsed.output, "");
}

}  // namespace gw::test
