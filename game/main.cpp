// gpuwars: parses the command line, runs the verb, and turns every error into one sentence and an exit code.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <variant>
#include <vector>

#include "game/cli/command_line.h"
#include "gpu/exec/float_state.h"
#include "host/platform/interrupt.h"
#include "host/platform/user_error.h"

namespace {

using namespace gw;

int fail(ExitCode code, std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');  // one sentence is one line
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return exitStatus(int(code));
}

}  // namespace

int main(int argc, char** argv) {
  setFloatState();  // a library that was loaded before may have changed it
  const ParsedCommandLine parsed = parseCommandLine(std::vector<std::string>(argv + 1, argv + argc));
  if (!parsed.run) {
    std::fputs(parsed.output.c_str(), stdout);
    return parsed.error.empty() ? int(parsed.code) : fail(parsed.code, parsed.error);
  }
  std::signal(SIGCHLD, SIG_DFL);  // else the exit codes of programs that it starts may be lost
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is a failed write, which is reported as an error
  try {
    return exitStatus(int(std::visit([](const auto& options) { return runVerb(options); }, parsed.options)));
  } catch (const UserError& error) {
    return fail(error.code, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::failedRun, "There is not enough memory: choose a smaller --enemies.");
  } catch (const std::exception& error) {
    return fail(ExitCode::failedRun, error.what());
  }
}
