// Completion for bash, made from the tables of the command line.
#pragma once

#include <string>
#include <vector>

#include "host/cli/command_text.h"

namespace gw {

// A script that bash sources; it needs nothing beside bash. The first verb is the one that runs when none is named.
std::string bashCompletion(const ProgramText& program, const std::vector<VerbText>& verbs);

}  // namespace gw
