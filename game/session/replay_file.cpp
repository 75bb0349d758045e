#include "game/session/replay_file.h"

#include <fmt/format.h>

#include <cstdio>

#include "game/replay/replay_reader.h"
#include "host/platform/user_error.h"

namespace gw {

Replay readWatched(const std::filesystem::path& file) {
  Replay replay = readReplay(file, SimulationVersions::current, Completeness::partial);
  if (!replay.whole) {
    std::fprintf(stderr, "%s has no end: what there is of it is shown, %u ticks; 'gpuwars trim' makes it whole.\n",
                 file.c_str(), replay.ticks());
  }
  return replay;
}

uint32_t tickInside(const std::filesystem::path& file, const char* option, uint32_t tick, const Replay& replay) {
  if (tick <= replay.ticks()) return tick;
  throw UserError(ExitCode::badUsage,
                  fmt::format("'{} {}' is past the last tick of {}, which is {}; give a smaller one.", option, tick,
                              file.string(), replay.ticks()));
}

}  // namespace gw
