#include "game/cli/trim_options.h"

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {

void TrimOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  options.file("FILE", "the replay to run again", file);
  options.path("--out", "write the new replay to OUT, which may be FILE itself", "OUT", outPath);
  options.require("--out");
  options.integer("--to", "the last tick to keep (the replay's last)", 1, kMaxTicks, toTick);
}

}  // namespace gw
