// Verbs that need a window, in every build: one without a window refuses them.
#pragma once

#ifdef GW_WINDOW
#include "game/app/window_sessions.h"
#else
#include "game/cli/play_options.h"
#include "game/cli/replay_options.h"
#include "host/platform/user_error.h"

namespace gw {

[[noreturn]] inline void refuseWindow() {
  throw UserError(ExitCode::failedRun,
                  "This build has no window: use --headless, or 'gpuwars verify' for a replay, or build with "
                  "-DGW_WINDOW=ON.");
}

[[noreturn]] inline ExitCode playWindow(const PlayOptions&) {
  refuseWindow();
}
[[noreturn]] inline ExitCode watchReplay(const ReplayOptions&) {
  refuseWindow();
}

}  // namespace gw
#endif
