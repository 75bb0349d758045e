// gpuwars play: what is played, how it ends, and what is written.
#pragma once

#include "game/cli/computing_options.h"
#include "game/cli/desktop_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct GameOptions {
  Mode mode = Mode::arcade;
  std::optional<uint64_t> seed;  // none: headless runs take 1, windows a new one each time
  uint32_t enemies = 8192;
  Autopilot autopilot = Autopilot::none;

  void declareGame(OptionSet& options);
};

struct PlayOptions : GameOptions, ComputingOptions, DesktopOptions {
  static constexpr const char* kName = "play";
  static constexpr const char* kSummary = "Play the game; this is the default verb.";

  bool headless = false;
  uint32_t ticks = 0;                    // 0: until the game is over; never 0 when headless
  std::filesystem::path recordPath;      // empty: none; so for all paths
  std::filesystem::path hashesPath;      // headless: one line a tick; "-" is stdout
  std::filesystem::path screenshotPath;  // headless: PNG of the last tick; its size is the window's
  std::string text;                      // the command line as given, for the header of a replay

  void declare(OptionSet& options);
  void check();
};

ExitCode runVerb(const PlayOptions& options);  // game/commands/play.cpp

}  // namespace gw
