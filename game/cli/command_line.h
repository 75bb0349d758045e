// The whole command line (docs and scripts depend on it), parsed into plain data. Nothing is opened, run or printed
// here.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "game/cli/devices_options.h"
#include "game/cli/diff_options.h"
#include "game/cli/play_options.h"
#include "game/cli/probe_options.h"
#include "game/cli/profile_options.h"
#include "game/cli/render_options.h"
#include "game/cli/replay_options.h"
#include "game/cli/trim_options.h"
#include "game/cli/verify_options.h"
#include "host/cli/command_text.h"

namespace gw {

// The table of verbs, in the order of --help; the first runs when none is named. A row is a struct with the verb's
// name, its summary and its options; runVerb() of it is in game/commands. The parser, help, man pages and completion
// read this table.
using VerbOptions = std::variant<PlayOptions, ReplayOptions, VerifyOptions, RenderOptions, ProfileOptions, TrimOptions,
                                 DiffOptions, DevicesOptions, ProbeOptions>;

struct ParsedCommandLine {
  bool run = false;  // false: print the texts below and exit with `code`
  VerbOptions options;
  ExitCode code = ExitCode::fine;
  std::string output;  // for stdout: help, version; ends in a newline
  std::string error;   // for stderr: one sentence with a remedy, no newline
};

// `arguments` without the program's name. Never throws on what a user can pass.
ParsedCommandLine parseCommandLine(const std::vector<std::string>& arguments);

const ProgramText& programText();
std::vector<VerbText> describeCommandLine();

}  // namespace gw
