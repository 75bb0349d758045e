#include "game/tables/wave_table.h"

#include <fmt/format.h>

#include "game/tables/enemy_table.h"
#include "game/tables/toml_reader.h"

namespace gw {
namespace {

// In Pattern's order.
constexpr std::string_view kPatterns[] = {"ring", "spiral", "cluster", "corners", "wall", "rain", "river"};
static_assert(std::size(kPatterns) == size_t(Pattern::count));

constexpr uint32_t kLatestWave_s = 3600;
constexpr uint32_t kLargestGroup = 100'000;

WaveGroup readGroup(TomlTable& table, const Rules& rules) {
  WaveGroup group{};
  group.count = table.integer32("count", 1, kLargestGroup);
  const std::string type = table.string("type");
  group.type = findEnemyType(rules, type);
  if (group.type == rules.enemyTypeCount) {
    table.refuse("type", fmt::format("'{}' is not an enemy type; choose one of: {}", type, enemyTypeNames(rules)));
  }
  group.pattern = Pattern(table.choice("pattern", kPatterns));
  table.done();
  return group;
}

Wave readWave(TomlTable& table, const Rules& rules) {
  Wave wave{};
  wave.at_ticks = table.integer32("at_s", 0, kLatestWave_s) * kTicksPerSecond;
  if (rules.waveCount && wave.at_ticks <= rules.waves[rules.waveCount - 1].at_ticks) {
    table.refuse("at_s", fmt::format("{} s does not come after the wave before ({} s); order waves by time",
                                     wave.at_ticks / kTicksPerSecond,
                                     rules.waves[rules.waveCount - 1].at_ticks / kTicksPerSecond));
  }
  for (TomlTable& group : table.tables("groups", kMaxGroups)) wave.groups[wave.groupCount++] = readGroup(group, rules);
  table.done();
  return wave;
}

}  // namespace

void readWaveTable(const RuleText& text, Rules& rules) {
  TomlTable document = TomlTable::parse(text);
  for (TomlTable& table : document.tables("wave", kMaxWaves)) {
    rules.waves[rules.waveCount] = readWave(table, rules);
    ++rules.waveCount;
  }
  document.done();
}

}  // namespace gw
