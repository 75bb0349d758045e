// The rule tables as text, with the names that messages show. The text travels: a replay embeds it, so
// that tuning a table in assets/ does not kill old replays.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "host/platform/user_error.h"

namespace gw {

// One sentence: file, line, key, what is wrong, and what to do about it.
struct TableError : UserError {
  explicit TableError(const std::string& sentence) : UserError(ExitCode::badFile, sentence) {}
};

struct RuleText {
  std::string name;  // as messages show it, e.g. "assets/waves.toml"; not part of the rules
  std::string text;

  friend bool operator==(const RuleText&, const RuleText&) = default;
};

struct RuleTexts {
  RuleText game, enemies, waves;

  friend bool operator==(const RuleTexts&, const RuleTexts&) = default;
};

// The longest table, in bytes: all three fit in one chunk of a replay.
inline constexpr size_t kMaxRuleText = 256 * 1024;

// Reads game.toml, enemies.toml and waves.toml. Throws TableError when one is missing, unreadable or
// longer than kMaxRuleText; what the text says is loadRules()' business.
RuleTexts readRuleTexts(const std::filesystem::path& assetsDir);

}  // namespace gw
