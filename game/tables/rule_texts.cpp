#include "game/tables/rule_texts.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gw {
namespace {

RuleText readRuleText(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw TableError(
        fmt::format("{}: there is no such file; reinstall the game or name the folder with --assets", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw TableError(fmt::format("{}: the file cannot be opened ({}); give yourself the right to read it",
                                 path.string(), std::strerror(errno)));
  }
  // One byte more than allowed, so that a longer file shows without being read whole.
  std::string text(kMaxRuleText + 1, '\0');
  file.read(text.data(), std::streamsize(text.size()));
  if (file.bad()) throw TableError(fmt::format("{}: reading failed; check the disk", path.string()));
  text.resize(size_t(file.gcount()));
  if (text.size() > kMaxRuleText) {
    throw TableError(fmt::format("{}: the table is longer than {} bytes; shorten it", path.string(), kMaxRuleText));
  }
  return {path.string(), std::move(text)};
}

}  // namespace

RuleTexts readRuleTexts(const std::filesystem::path& assetsDir) {
  return {readRuleText(assetsDir / "game.toml"), readRuleText(assetsDir / "enemies.toml"),
          readRuleText(assetsDir / "waves.toml")};
}

}  // namespace gw
