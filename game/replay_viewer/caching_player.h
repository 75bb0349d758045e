// A replay player that stores a snapshot in the cache whenever one is due.
#pragma once

#include "game/replay_viewer/replay_player.h"
#include "game/replay_viewer/snapshot_cache.h"

namespace gw {

class CachingPlayer {
 public:
  CachingPlayer(ReplayPlayer player, SnapshotCache& cache);

  void playOne();
  void restore(const RunSnapshot& snapshot);

  uint32_t tick() const { return player_.tick(); }
  bool ended() const { return player_.ended(); }
  Run& run() { return player_.run(); }
  const Run& run() const { return player_.run(); }

 private:
  void cacheIfDue();

  ReplayPlayer player_;
  SnapshotCache& cache_;
  double cost_ms_ = 0;  // of this thread, for the ticks since the last snapshot
};

}  // namespace gw
