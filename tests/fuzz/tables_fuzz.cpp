// The rule tables. The first byte says which one is made up; the other two are the game's own.
#include <cstring>

#include "game/tables/tables.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  static const RuleTexts own = readRuleTexts(GW_ASSETS_DIR);
  if (size == 0) return 0;
  RuleTexts texts = own;
  RuleText* tables[] = {&texts.game, &texts.enemies, &texts.waves};
  tables[data[0] % 3]->text = fuzz::textOf(data + 1, size - 1);
  try {
    const Rules rules = loadRules(texts), again = loadRules(texts);
    fuzz::demand(std::memcmp(&rules, &again, sizeof rules) == 0, "equal texts give other bytes");
  } catch (const TableError& error) {
    fuzz::demandSentence(error.what());
  }
  return 0;
}
