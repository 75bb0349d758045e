#include "game/cli/replay_options.h"

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {

void ReplayOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  declareDesktop(options);
  options.file("FILE", "the replay to watch", file);
  options.number("--speed", "times real time (1)", 0.1, 16, speed);
  options.integer("--from", "the tick to start watching at", 0, kMaxTicks, fromTick);
  options.flag("--quit-at-end", "end the program after the last tick", quitAtEnd);
}

}  // namespace gw
