#include "game/tables/enemy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "game/sim/behaviour/state_tables.h"
#include "game/tables/toml_reader.h"
#include "render/sprite_shapes.h"

namespace gw {
namespace {

constexpr std::string_view kBounds[] = {"circle", "rectangle"};
// The names of the shapes that enemies may have, in the order of Shape.
std::span<const std::string_view> shapeNames() {
  static const auto names = [] {
    std::array<std::string_view, kEnemyShapes> list;
    for (uint32_t shape = 0; shape < kEnemyShapes; ++shape) list[shape] = kSpriteShapes[shape].name;
    return list;
  }();
  return names;
}

void readName(TomlTable& table, const Rules& rules, EnemyRules& enemy) {
  const std::string name = table.string("name");
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (name.empty() || name.size() > kMaxNameLength || !std::all_of(name.begin(), name.end(), allowed)) {
    table.refuse("name", fmt::format("'{}' is not a name; use 1 to {} small letters, digits or underscores", name,
                                     kMaxNameLength));
  }
  if (findEnemyType(rules, name) < rules.enemyTypeCount) {
    table.refuse("name", fmt::format("'{}' stands in the table twice; give each type its own name", name));
  }
  std::memcpy(enemy.name, name.data(), name.size());
}

void readBounds(TomlTable& table, EnemyRules& enemy) {
  enemy.bounds = Bounds(table.choice("bounds", kBounds));
  if (enemy.bounds == Bounds::circle) {
    enemy.halfWidth_m = enemy.halfHeight_m = table.number("radius_m", 0.05, 5);
  } else {
    enemy.halfWidth_m = table.number("width_m", 0.1, 10) / 2;  // halving is exact
    enemy.halfHeight_m = table.number("height_m", 0.1, 10) / 2;
  }
}

// From the centre to the farthest point of the body.
double reach(const EnemyRules& enemy) {
  return enemy.bounds == Bounds::circle ? enemy.halfWidth_m : std::hypot(enemy.halfWidth_m, enemy.halfHeight_m);
}

EnemyRules readEnemy(TomlTable& table, const Rules& rules) {
  EnemyRules enemy{};
  readName(table, rules, enemy);
  enemy.machine = Machine(table.choice("machine", kMachineNames));
  readBounds(table, enemy);
  enemy.speed_mps = table.number("speed_mps", 0.1, 18);  // damaged and pushed it stays under what integrate allows
  enemy.sight_m = table.number("sight_m", 1, 1000);
  enemy.vision_m = table.number("vision_m", 0.5, 20);
  enemy.energy = table.number("energy", 1, 1000);
  enemy.mass = table.number("mass", 0.1, 100);
  enemy.contact_us = table.integer32("contact_us", 1, 100'000);
  enemy.value = table.integer32("value", 0, 1'000'000);
  enemy.bits = table.integer32("bits", 0, 64);
  if (kDodgingMachines >> uint32_t(enemy.machine) & 1u) {
    enemy.avoidCooldown_ticks = table.integer32("avoid_cooldown_ticks", 0, 3600);
  }
  enemy.shape = Shape(table.choice("shape", shapeNames()));
  enemy.colour = table.integer32("colour", 0, 0xffffff);
  table.done();
  return enemy;
}

// Bodies that touch must see each other, or only one of the two would be pushed.
void checkVision(const std::vector<TomlTable>& tables, const Rules& rules) {
  double largest = 0;
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) largest = std::max(largest, reach(rules.enemies[i]));
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    const double needed = reach(rules.enemies[i]) + largest;
    if (rules.enemies[i].vision_m < needed) {
      tables[i].refuse("vision_m", fmt::format("{:.2f} m does not reach a touching body of the largest type; "
                                               "give at least {:.2f}",
                                               rules.enemies[i].vision_m, needed));
    }
  }
}

}  // namespace

uint32_t findEnemyType(const Rules& rules, std::string_view name) {
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    if (name == rules.enemies[i].name) return i;
  }
  return rules.enemyTypeCount;
}

std::string enemyTypeNames(const Rules& rules) {
  std::string names;
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    if (i) names += ", ";
    names += rules.enemies[i].name;
  }
  return names;
}

void readEnemyTable(const RuleText& text, Rules& rules) {
  TomlTable document = TomlTable::parse(text);
  std::vector<TomlTable> tables = document.tables("enemy", kMaxEnemyTypes);
  for (TomlTable& table : tables) {
    rules.enemies[rules.enemyTypeCount] = readEnemy(table, rules);
    ++rules.enemyTypeCount;
  }
  document.done();
  checkVision(tables, rules);
}

}  // namespace gw
