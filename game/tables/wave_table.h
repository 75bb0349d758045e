// waves.toml: one [[wave]] per time of the arcade's timetable, each with its groups.
#pragma once

#include "game/sim/rules.h"
#include "game/tables/rule_texts.h"

namespace gw {

// Fills rules.waves; rules.enemies must be filled. Throws TableError.
void readWaveTable(const RuleText& text, Rules& rules);

}  // namespace gw
