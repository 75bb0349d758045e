// gpuwars: parses the command line, runs the verb, and turns whatever goes wrong into one sentence and an
// exit code.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <vector>

#include "game/cli/command_line.h"
#include "game/commands/commands.h"
#include "gpu/exec/float_state.h"
#include "host/platform/interrupt.h"
#include "host/platform/user_error.h"

namespace {

using namespace gw;

ExitCode withoutWindow() {
  throw UserError(ExitCode::failedRun,
                  "This build has no window: use --headless, or 'gpuwars verify' for a replay, or build with "
                  "-DGW_WINDOW=ON.");
}

ExitCode runVerb(const Options& options) {
  switch (options.verb) {
#ifdef GW_WINDOW
    case Verb::play:
      return options.headless ? playHeadless(options) : playWindow(options);
    case Verb::replay:
      return watchReplay(options);
#else
    case Verb::play:
      return options.headless ? playHeadless(options) : withoutWindow();
    case Verb::replay:
      return withoutWindow();
#endif
    case Verb::verify:
      return verifyReplays(options);
    case Verb::render:
      return renderReplay(options);
    case Verb::profile:
      return profileGame(options);
    case Verb::probe:
      return answerAsProbe(options);
    case Verb::trim:
      return trimReplay(options);
    case Verb::diff:
      return diffTwoReplays(options);
    case Verb::devices:
      return listDevicesCommand(options);
  }
  return withoutWindow();
}

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
  std::signal(SIGCHLD, SIG_DFL);  // else the ends of programs that it starts may be kept from it
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is a write that fails, and is reported in a sentence
  try {
    return exitStatus(int(runVerb(parsed.options)));
  } catch (const UserError& error) {
    return fail(error.code, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::failedRun, "There is not enough memory: choose a smaller --enemies.");
  } catch (const std::exception& error) {
    return fail(ExitCode::failedRun, error.what());
  }
}
