#include "game/replay_viewer/caching_player.h"

#include <utility>

#include "host/platform/clock.h"

namespace gw {

CachingPlayer::CachingPlayer(ReplayPlayer player, SnapshotCache& cache) : player_(std::move(player)), cache_(cache) {
  cacheIfDue();
}

void CachingPlayer::playOne() {
  const double begin_s = threadTime_s();  // wall time would include waiting for other programs
  player_.playOne();
  cost_ms_ += 1e3 * (threadTime_s() - begin_s);
  cacheIfDue();
}

void CachingPlayer::restore(const RunSnapshot& snapshot) {
  player_.run().restore(snapshot);
  cost_ms_ = 0;
}

void CachingPlayer::cacheIfDue() {
  if (cache_.has(tick())) {
    cost_ms_ = 0;
  } else if (cache_.wanted(tick(), cost_ms_)) {
    cache_.keep(player_.run().snapshot());
    cost_ms_ = 0;
  }
}

}  // namespace gw
