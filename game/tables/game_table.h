// game.toml: everything that is neither an enemy type nor a wave.
#pragma once

#include "game/sim/rules.h"
#include "game/tables/rule_texts.h"

namespace gw {

// Fills what readEnemyTable() and readWaveTable() leave; both must have run, since the endless waves name
// enemy types and follow the last wave. Throws TableError.
void readGameTable(const RuleText& text, Rules& rules);

}  // namespace gw
