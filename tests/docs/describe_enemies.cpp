// describe_enemies ASSETS: the state tables and the enemies' numbers as JSON, for what draws and writes
// docs/reference/enemies.md from them.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "game/sim/behaviour/state_tables.h"
#include "game/tables/tables.h"

namespace {

using namespace gw;
using Json = nlohmann::ordered_json;

Json statesOf(uint32_t mask) {
  Json names = Json::array();
  for (uint32_t s = 0; s < kStates; ++s) {
    if (mask & in(State(s))) names.push_back(nameOf(State(s)));
  }
  return names;
}

Json rowsOf(Machine machine) {
  const MachineTable& table = tableOf(machine);
  Json rows = Json::array();
  for (uint32_t r = 0; r < table.count; ++r) {
    const Transition& row = table.rows[r];
    Json needs = Json::array();
    for (uint32_t c = 0; c < kConditionCount; ++c) {
      if (row.needs & 1u << c) needs.push_back(nameOf(Condition(1u << c)));
    }
    rows.push_back({{"from", statesOf(row.from)}, {"needs", needs}, {"to", nameOf(row.to)}});
  }
  return rows;
}

Json numbersOf(const EnemyRules& enemy) {
  return {{"name", enemy.name},
          {"machine", nameOf(enemy.machine)},
          {"circle", enemy.bounds == Bounds::circle},
          {"halfWidth_m", enemy.halfWidth_m},
          {"halfHeight_m", enemy.halfHeight_m},
          {"speed_mps", enemy.speed_mps},
          {"sight_m", enemy.sight_m},
          {"vision_m", enemy.vision_m},
          {"energy", enemy.energy},
          {"mass", enemy.mass},
          {"contact_us", enemy.contact_us},
          {"value", enemy.value},
          {"bits", enemy.bits},
          {"avoidCooldown_ticks", enemy.avoidCooldown_ticks}};
}

Json numbersOf(const Rules::Steering& steering) {
  return {{"wanderSpeed", steering.wanderSpeed},
          {"damagedSpeed", steering.damagedSpeed},
          {"press_mps", steering.press_mps},
          {"sightLost", steering.sightLost},
          {"sidewaysBeyond_m", steering.sidewaysBeyond_m},
          {"threat_m", steering.threat_m},
          {"threatMargin_m", steering.threatMargin_m},
          {"avoid_mps", steering.avoid_mps},
          {"avoid_ticks", steering.avoid_ticks},
          {"escapeBelow", steering.escapeBelow},
          {"recoveredAt", steering.recoveredAt},
          {"recover_per_s", steering.recover_per_s},
          {"escapeSpeed", steering.escapeSpeed},
          {"escapeWall_m", steering.escapeWall_m}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: describe_enemies ASSETS\n");
    return 2;
  }
  try {
    const Rules rules = loadRules(readRuleTexts(argv[1]));
    Json json;
    for (uint32_t m = 0; m < kMachines; ++m) json["machines"][nameOf(Machine(m))] = rowsOf(Machine(m));
    for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) json["enemies"].push_back(numbersOf(rules.enemies[t]));
    json["steering"] = numbersOf(rules.steering);
    json["endless"] = {{"paceGrowth", rules.endless.paceGrowth}, {"paceMost", rules.endless.paceMost}};
    json["weakEnergy"] = rules.ship.weakEnergy;
    json["announced_ticks"] = rules.world.announced_ticks;
    std::printf("%s\n", json.dump(1).c_str());
    return 0;
  } catch (const TableError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
