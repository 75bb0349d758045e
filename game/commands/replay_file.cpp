#include "game/commands/replay_file.h"

#include <fmt/format.h>

#include "game/replay/replay_reader.h"
#include "game/user_error.h"

namespace gw {

Replay readWatched(const Options& options) {
  return readReplay(options.files.front(), SimulationVersions::current, Completeness::partial);
}

uint32_t tickInside(const Options& options, const char* option, uint32_t tick, const Replay& replay) {
  if (tick <= replay.ticks()) return tick;
  throw UserError(ExitCode::badUsage,
                  fmt::format("'{} {}' is past the last tick of {}, which is {}; give a smaller one.", option, tick,
                              options.files.front().string(), replay.ticks()));
}

}  // namespace gw
