#include "game/app/player_settings.h"

#include <cstdio>

namespace gw {

namespace {

void print(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) std::fprintf(stderr, "%s\n", sentence.c_str());
}

}  // namespace

PlayerSettings::PlayerSettings(const DesktopOptions& options)
    : file(options.settingsPath.empty() ? usualSettingsPath() : options.settingsPath) {
  std::vector<std::string> sentences;
  now = file.read(sentences);
  print(sentences);
}

void PlayerSettings::write(const Settings& before) {
  if (now == before) return;
  std::vector<std::string> sentences;
  file.write(before, now, sentences);
  print(sentences);
}

}  // namespace gw
