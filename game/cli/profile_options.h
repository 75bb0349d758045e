// gpuwars profile: what is measured, how it is drawn, and where the report goes.
#pragma once

#include <vector>

#include "game/cli/computing_options.h"
#include "game/cli/desktop_options.h"
#include "game/cli/scene_kind.h"
#include "host/platform/exit_code.h"

namespace gw {

// What is played.
struct SceneOptions {
  profile::SceneKind scene = profile::SceneKind::fiveMinutes;
  std::filesystem::path replayPath;   // instead of a scene
  std::vector<uint32_t> enemiesList;  // empty: the scene's own
  std::string compare;                // contenders, with commas; empty: broadPhase alone
  uint32_t runs = 10;                 // of each contender
  uint32_t ticks = 0, seconds = 0;    // length of a run; 0: all of the scene

  void declareScene(OptionSet& options);
};

// What is drawn.
struct LookOptions {
  bool headless = false;     // draw without a window
  bool drawNothing = false;  // simulation only
  bool paced = false;        // ticks in real time
  bool wholeWorld = false;   // is drawn, and not what a player sees
  bool effects = true;       // particles, flashes, bending, shake
  float glow = 0.5f;         // Settings::Effects::glow

  void declareLook(OptionSet& options);
};

struct ProfileOptions : ComputingOptions, SceneOptions, LookOptions, SizeOptions {
  static constexpr const char* kName = "profile";
  static constexpr const char* kSummary = "Measure frame rates and stage times; write a report with pictures.";

  std::filesystem::path outPath;  // a folder
  std::filesystem::path tracePath;
  std::filesystem::path baselinePath;  // an earlier report.json

  void declare(OptionSet& options);
  void check();
};

ExitCode runVerb(const ProfileOptions& options);  // game/commands/profile.cpp

}  // namespace gw
