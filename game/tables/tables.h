// From rule texts to the plain numbers that the kernels use.
#pragma once

#include "game/sim/rules.h"
#include "game/tables/rule_texts.h"

namespace gw {

// Every key is required, unknown ones are refused, every number has a range and every reference is
// checked; throws TableError otherwise. Equal texts give equal bytes, padding included, on every machine.
Rules loadRules(const RuleTexts& texts);

}  // namespace gw
