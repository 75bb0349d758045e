#include "game/replay_viewer/replay_player.h"

#include <algorithm>

namespace gw {

void ReplayPlayer::playTo(uint32_t tick) {
  const uint32_t stop = std::min(tick, replay_.ticks());
  uint32_t queued = this->tick();
  while (this->tick() < stop && !run_.over()) {
    while (queued < stop && run_.queued() < Simulation::kTicksInFlight) run_.queue(replay_.inputs[queued++]);
    if (!run_.collect()) break;
    const TickReport& report = run_.last();
    difference_.compare(report.tick, report.hash, replay_.hashes[report.tick - 1]);
  }
  while (run_.queued() > 0) run_.collect();  // ticks after an end that the recording does not have
}

}  // namespace gw
