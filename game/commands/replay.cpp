// gpuwars replay FILE: watch a run in a window.
#include "game/cli/replay_options.h"
#include "game/commands/window.h"

namespace gw {

ExitCode runVerb(const ReplayOptions& options) {
  return watchReplay(options);
}

}  // namespace gw
