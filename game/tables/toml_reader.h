// One TOML table, read key by key with checks: every getter refuses a missing key, a value of another
// kind and a value out of its range by throwing TableError with file, line and key. done() then refuses
// the keys that were not asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/tables/rule_texts.h"

namespace gw {

class TomlTable {
 public:
  // Longer lines are refused: they bound how deep dotted keys can nest.
  static constexpr size_t kMaxLine = 200;

  static TomlTable parse(const RuleText& text);

  TomlTable(TomlTable&&) noexcept;
  TomlTable& operator=(TomlTable&&) noexcept;
  ~TomlTable();

  // A finite number in [least, most], rounded to float once.
  float number(std::string_view key, double least, double most);
  // A whole number in [least, most].
  uint64_t integer(std::string_view key, uint64_t least, uint64_t most);
  uint32_t integer32(std::string_view key, uint32_t least, uint32_t most) {
    return uint32_t(integer(key, least, most));
  }
  // Whole numbers in [least, most], each larger than the one before, at most `maxCount` of them.
  std::vector<uint64_t> ascendingIntegers(std::string_view key, size_t maxCount, uint64_t least, uint64_t most);
  std::string string(std::string_view key);
  // The index among `names` of a string.
  uint32_t choice(std::string_view key, std::span<const std::string_view> names);
  TomlTable table(std::string_view key);
  // [[key]]: 1 to maxCount tables.
  std::vector<TomlTable> tables(std::string_view key, size_t maxCount);

  // Refuses keys that no getter asked for.
  void done() const;

  // Throws TableError about `key`; `complaint` ends in the remedy.
  [[noreturn]] void refuse(std::string_view key, const std::string& complaint) const;

 private:
  struct Impl;
  explicit TomlTable(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gw
