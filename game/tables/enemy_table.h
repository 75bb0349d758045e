// enemies.toml: one [[enemy]] per type, in table order.
#pragma once

#include <string_view>

#include "game/sim/rules.h"
#include "game/tables/rule_texts.h"

namespace gw {

// Fills rules.enemies; the rest must be zeros. Throws TableError.
void readEnemyTable(const RuleText& text, Rules& rules);

// The index of a type by name, or enemyTypeCount.
uint32_t findEnemyType(const Rules& rules, std::string_view name);

// "triangle, quad, hexagon", for messages.
std::string enemyTypeNames(const Rules& rules);

}  // namespace gw
