// Runs ahead through a replay on a thread of its own, and leaves moments: soon going forward is as fast as going back.
// It has one core's idle time and no more, so that whoever watches never waits for it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include "game/replay_viewer/keeping_player.h"

namespace gw {

class Scout {
 public:
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // Everything that is referred to must outlive this. `make` is called on the scout's thread.
  Scout(const Replay& replay, FirstDifference& difference, Moments& moments, Make make);
  ~Scout();  // leaves the tick that is being computed, and ends
  Scout(const Scout&) = delete;
  Scout& operator=(const Scout&) = delete;

  bool done() const { return done_; }

 private:
  void work(const Replay& replay, FirstDifference& difference, Moments& moments, const Make& make);

  std::atomic<bool> stop_{false}, done_{false};
  std::thread thread_;
};

}  // namespace gw
