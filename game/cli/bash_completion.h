// Completion for bash, made from the tables of the command line.
#pragma once

#include <string>
#include <vector>

#include "game/cli/command_line_text.h"

namespace gw {

// A script that bash sources; it needs nothing beside bash.
std::string bashCompletion(const std::vector<VerbText>& verbs);

}  // namespace gw
