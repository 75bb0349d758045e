// Inputs that no bot makes, for the golden replays: each script is a function of the tick and of the report before it,
// so that recording it again gives the same inputs to today's rules.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "game/sim/input_record.h"
#include "game/sim/simulation.h"

namespace gw {

// The record of the tick that comes next, from the report of the one before; before the first, an empty one. May keep
// what it needs.
using Script = std::function<InputRecord(const TickReport&)>;

// Makers by name, as golden.list names them.
using Scripts = std::map<std::string, std::function<Script()>>;
void addExtremes(Scripts& scripts);
void addPads(Scripts& scripts);
void addKeys(Scripts& scripts);

}  // namespace gw
