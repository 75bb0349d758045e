// The verbs. Each runs a parsed command line to its end and returns the exit code; what a user can mend
// is thrown as UserError, FileError or TableError, one sentence each.
#pragma once

#include "game/cli/command_line.h"

namespace gw {

ExitCode playWindow(const Options& options);
ExitCode playHeadless(const Options& options);
ExitCode watchReplay(const Options& options);
ExitCode verifyReplays(const Options& options);
ExitCode renderReplay(const Options& options);
ExitCode profileGame(const Options& options);
ExitCode answerAsProbe(const Options& options);
ExitCode trimReplay(const Options& options);
ExitCode diffTwoReplays(const Options& options);
ExitCode listDevicesCommand(const Options& options);

}  // namespace gw
