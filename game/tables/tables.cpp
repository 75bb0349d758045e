#include "game/tables/tables.h"

#include <cstring>
#include <type_traits>

#include "game/tables/enemy_table.h"
#include "game/tables/game_table.h"
#include "game/tables/wave_table.h"
#include "gpu/exec/float_state.h"

namespace gw {

static_assert(std::is_trivially_copyable_v<Rules>);

Rules loadRules(const RuleTexts& texts) {
  setFloatState();  // a driver may have changed this thread's: equal texts give equal bytes
  Rules rules;
  std::memset(&rules, 0, sizeof rules);  // padding too: the rules are uploaded and hashed as bytes
  readEnemyTable(texts.enemies, rules);
  readWaveTable(texts.waves, rules);
  readGameTable(texts.game, rules);
  return rules;
}

}  // namespace gw
