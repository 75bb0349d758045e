#include "game/cli/render_options.h"

#include <fmt/format.h>

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {
namespace {

constexpr Choice<uint32_t> kFrameRates[] = {{"30", 30}, {"60", 60}, {"120", 120}};

}  // namespace

void RenderOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  options.file("FILE", "the replay to draw", file);
  options.path("--out", "a folder for one picture per frame, FILE.png for a single tick, or FILE.mp4 for a video",
               "OUT", outPath);
  options.require("--out");
  options.integer("--from", "the first tick to draw (1)", 1, kMaxTicks, fromTick);
  options.integer("--to", "the last tick to draw (the replay's last); with FILE.png the only one", 1, kMaxTicks,
                  toTick);
  declareSize(options);
  options.choice("--fps", kFrameRates, "pictures per second of game time", "60", framesPerSecond);
  options.choice("--hud", kOnOff, "score, budget and counts", "on", hud);
}

// The name of the output decides what is made.
void RenderOptions::check() {
  checkComputing(GameSource::replay);
  const std::string ending = outPath.extension().string();
  for (const char* other :
       {".avi", ".bmp", ".gif", ".jpeg", ".jpg", ".mkv", ".mov", ".webm", ".webp", ".MP4", ".PNG"}) {
    if (ending != other) continue;
    throw UsageError(fmt::format("'--out {}' is not a supported kind of file; give a folder, FILE.png or FILE.mp4",
                                 outPath.string()));
  }
  if (ending == ".mp4" && (width_px % 2 != 0 || height_px % 2 != 0)) {
    throw UsageError(fmt::format("'--width {}' and '--height {}' are not valid for a video; give even numbers",
                                 width_px, height_px));
  }
  if (fromTick && toTick && *fromTick > toTick) {
    throw UsageError(fmt::format("'--from {}' comes after '--to {}'; exchange them", *fromTick, toTick));
  }
}

}  // namespace gw
