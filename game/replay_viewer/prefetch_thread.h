// Plays ahead through a replay on a background thread and fills the snapshot cache, so that seeking forward becomes as
// fast as seeking back. One thread at the lowest priority: playback never waits for it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include "game/replay_viewer/caching_player.h"

namespace gw {

class PrefetchThread {
 public:
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // All referenced objects must outlive this. `make` is called on the new thread.
  PrefetchThread(const Replay& replay, FirstDifference& difference, SnapshotCache& cache, Make make);
  ~PrefetchThread();  // stops after the tick in progress
  PrefetchThread(const PrefetchThread&) = delete;
  PrefetchThread& operator=(const PrefetchThread&) = delete;

  bool done() const { return done_; }

 private:
  void work(const Replay& replay, FirstDifference& difference, SnapshotCache& cache, const Make& make);

  std::atomic<bool> stop_{false}, done_{false};
  std::thread thread_;
};

}  // namespace gw
