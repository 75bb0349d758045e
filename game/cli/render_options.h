// gpuwars render FILE --out OUT: which ticks of a replay are drawn, and into what.
#pragma once

#include "game/cli/computing_options.h"
#include "game/cli/desktop_options.h"
#include "host/platform/exit_code.h"

namespace gw {

struct RenderOptions : ComputingOptions, SizeOptions {
  static constexpr const char* kName = "render";
  static constexpr const char* kSummary = "Make a video or pictures of a replay; needs no display.";

  std::filesystem::path file;
  std::filesystem::path outPath;  // a folder, or a file that ends in .png or .mp4
  std::optional<uint32_t> fromTick;
  uint32_t toTick = 0;            // 0: the last
  uint32_t framesPerSecond = 60;  // of game time
  bool hud = true;

  void declare(OptionSet& options);
  void check();
};

ExitCode runVerb(const RenderOptions& options);  // game/commands/render.cpp

}  // namespace gw
