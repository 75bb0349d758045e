// "PROGRAM VERB [OPTIONS]": finds the verb, lets it parse its options, and answers --help and --version.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/cli/command_text.h"
#include "host/cli/option_set.h"

namespace gw {

struct Verb {
  std::string name, summary;
  // Declares the options of the verb.
  std::function<void(OptionSet&)> declare;
  // Throws UsageError at the first contradiction among values that are each valid.
  std::function<void()> check;
};

struct ParsedVerb {
  size_t verb = 0;  // the index of the one to run, where `run`
  bool run = false;
  ExitCode code = ExitCode::fine;
  std::string output;  // for stdout: help, version; ends in a newline
  std::string error;   // for stderr: one sentence with a remedy, no newline
};

// `arguments` without the program's name. The first verb runs when none is named. Never throws on what a user can pass.
ParsedVerb parseVerb(const ProgramText& program, std::span<const Verb> verbs, std::vector<std::string> arguments);

std::vector<VerbText> describe(const ProgramText& program, std::span<const Verb> verbs);

// The arguments as one line, with quotes where a shell needs them.
std::string joined(const std::vector<std::string>& arguments);

}  // namespace gw
