// gpuwars replay FILE: which replay is watched, and from where.
#pragma once

#include "game/cli/computing_options.h"
#include "game/cli/desktop_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct ReplayOptions : ComputingOptions, DesktopOptions {
  static constexpr const char* kName = "replay";
  static constexpr const char* kSummary = "Watch a replay.";

  std::filesystem::path file;
  double speed = 1;  // times real time
  uint32_t fromTick = 0;
  bool quitAtEnd = false;

  void declare(OptionSet& options);
  void check() { checkComputing(GameSource::replay); }
};

ExitCode runVerb(const ReplayOptions& options);  // game/commands/replay.cpp

}  // namespace gw
