#include "game/app/player_settings.h"

#include <cstdio>

namespace gw {

namespace {

void say(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) std::fprintf(stderr, "%s\n", sentence.c_str());
}

}  // namespace

SettingsFile settingsFileOf(const Options& options) {
  return SettingsFile(options.settingsPath.empty() ? usualSettingsPath() : options.settingsPath);
}

Settings readPlayerSettings(SettingsFile& file) {
  std::vector<std::string> sentences;
  const Settings settings = file.read(sentences);
  say(sentences);
  return settings;
}

void writePlayerSettings(SettingsFile& file, const Settings& before, const Settings& now) {
  std::vector<std::string> sentences;
  file.write(before, now, sentences);
  say(sentences);
}

}  // namespace gw
