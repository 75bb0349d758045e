// Options that are fine each by itself and cannot go together.
#pragma once

#include "game/cli/command_line.h"

namespace gw {

// What --thesis stands for. Throws UsageError beside an option that says something else.
void takeThesis(Options& options);

// Throws UsageError, one sentence with a remedy, at the first contradiction. What a replay says is looked at when it
// is open.
void checkContradictions(const Options& options);

}  // namespace gw
