#include "game/cli/probe_options.h"

#include "host/cli/option_set.h"

namespace gw {

void ProbeOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  options.file("FILE", "the replay to play", file);
}

}  // namespace gw
