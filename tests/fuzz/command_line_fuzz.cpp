// The command line: each line of the input is one argument.
#include "game/cli/command_line.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  std::vector<std::string> arguments;
  std::string argument;
  for (const char letter : fuzz::textOf(data, size)) {
    if (letter == '\n') {
      arguments.push_back(argument);
      argument.clear();
    } else if (letter != '\0') {  // no shell can pass one
      argument += letter;
    }
  }
  const ParsedCommandLine parsed = parseCommandLine(arguments);
  if (parsed.run) return 0;
  fuzz::demand(parsed.code == ExitCode::fine ? !parsed.output.empty() : parsed.code == ExitCode::badUsage,
               "a command line that does not run says nothing, or ends as something else than bad usage");
  if (parsed.code != ExitCode::fine) fuzz::demand(!parsed.error.empty(), "there is no message");
  return 0;
}
