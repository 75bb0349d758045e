// What the options of several verbs have in common: a heading of --help, words, and the limits of a replay.
#pragma once

#include "game/replay/format.h"
#include "host/cli/option_set.h"

namespace gw {

inline constexpr const char* kDiagnostics = "Diagnostics";

inline constexpr Choice<bool> kOnOff[] = {{"on", true}, {"off", false}};

}  // namespace gw
