#include "game/replay/replay_diff.h"

#include <algorithm>
#include <string_view>

namespace gw {
namespace {

constexpr const char* kModes[] = {"arcade", "deadline", "swarm", "practice"};
constexpr const char* kAutopilots[] = {"none", "novice", "expert"};
constexpr const char* kGathers[] = {"exact", "adaptive", "fixed"};
constexpr const char* kSorts[] = {"bitonic", "odd-even"};

std::string yesOrNo(bool value) {
  return value ? "yes" : "no";
}

// Appends a pair where it differs.
void compare(std::vector<NamedDifference>& found, const char* name, const std::string& a, const std::string& b) {
  if (a != b) found.push_back({name, a, b});
}
void compare(std::vector<NamedDifference>& found, const char* name, uint64_t a, uint64_t b) {
  compare(found, name, std::to_string(a), std::to_string(b));
}

std::vector<NamedDifference> diffHeaders(const ReplayHeader& a, const ReplayHeader& b) {
  std::vector<NamedDifference> found;
  compare(found, "simulation version", a.simulationVersion, b.simulationVersion);
  compare(found, "seed", a.seed, b.seed);
  compare(found, "mode", kModes[size_t(a.mode)], kModes[size_t(b.mode)]);
  compare(found, "enemies", a.enemies, b.enemies);
  compare(found, "autopilot", kAutopilots[size_t(a.autopilot)], kAutopilots[size_t(b.autopilot)]);
  compare(found, "gather", kGathers[size_t(a.gather)], kGathers[size_t(b.gather)]);
  compare(found, "sort", kSorts[size_t(a.sort)], kSorts[size_t(b.sort)]);
  return found;
}

std::vector<NamedDifference> diffResults(const FinalReport& a, const FinalReport& b) {
  std::vector<NamedDifference> found;
  compare(found, "score", a.score, b.score);
  compare(found, "kills", a.kills, b.kills);
  compare(found, "frame time in us", a.frameTime_us, b.frameTime_us);
  compare(found, "over", yesOrNo(a.over), yesOrNo(b.over));
  return found;
}

// Takes a line and its end off the text.
std::string_view takeLine(std::string_view& text) {
  const size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

void diffTable(std::vector<TableDifference>& found, const char* file, const RuleText& a, const RuleText& b) {
  if (a.text == b.text) return;
  std::string_view restA = a.text, restB = b.text;
  TableDifference difference{file, 0, "", ""};
  std::string_view lineA, lineB;
  // Texts that differ do so in a line, or in whether the last one ends.
  do {
    ++difference.line;
    const bool moreA = !restA.empty(), moreB = !restB.empty();
    lineA = takeLine(restA);
    lineB = takeLine(restB);
    if (moreA != moreB) break;
  } while (lineA == lineB && (!restA.empty() || !restB.empty()));
  difference.a = lineA;
  difference.b = lineB;
  found.push_back(std::move(difference));
}

template <typename T>
std::optional<uint32_t> firstDifference(const std::vector<T>& a, const std::vector<T>& b) {
  const size_t both = std::min(a.size(), b.size());
  for (size_t i = 0; i < both; ++i) {
    if (!(a[i] == b[i])) return uint32_t(i);
  }
  return std::nullopt;
}

std::optional<FieldsDifference> diffFields(const Replay& a, const Replay& b, uint32_t tick) {
  const size_t index = (tick + kFieldHashesEvery_ticks - 1) / kFieldHashesEvery_ticks - 1;
  if (index >= a.fieldHashes.size() || index >= b.fieldHashes.size()) return std::nullopt;
  FieldsDifference difference{uint32_t(index + 1) * kFieldHashesEvery_ticks, {}};
  for (uint32_t field = 0; field < kHashFields; ++field) {
    if (a.fieldHashes[index][field] != b.fieldHashes[index][field]) difference.fields.push_back(field);
  }
  return difference;
}

}  // namespace

ReplayDiff diffReplays(const Replay& a, const Replay& b) {
  ReplayDiff diff;
  diff.ticks_a = a.ticks();
  diff.ticks_b = b.ticks();
  diff.whole_a = a.whole;
  diff.whole_b = b.whole;
  diff.header = diffHeaders(a.header, b.header);
  diffTable(diff.tables, "game.toml", a.rules.game, b.rules.game);
  diffTable(diff.tables, "enemies.toml", a.rules.enemies, b.rules.enemies);
  diffTable(diff.tables, "waves.toml", a.rules.waves, b.rules.waves);
  if (const auto at = firstDifference(a.inputs, b.inputs)) diff.input = {*at + 1, a.inputs[*at], b.inputs[*at]};
  if (const auto at = firstDifference(a.hashes, b.hashes)) {
    diff.hash = {*at + 1, a.hashes[*at], b.hashes[*at]};
    diff.fields = diffFields(a, b, *at + 1);
  }
  if (a.whole && b.whole) diff.result = diffResults(a.result, b.result);
  return diff;
}

}  // namespace gw
