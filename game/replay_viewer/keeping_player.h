// A player of a replay that leaves moments behind as it goes.
#pragma once

#include "game/replay_viewer/moments.h"
#include "game/replay_viewer/replay_player.h"

namespace gw {

class KeepingPlayer {
 public:
  KeepingPlayer(ReplayPlayer player, Moments& moments);

  void playOne();
  void restore(const RunMoment& moment);

  uint32_t tick() const { return player_.tick(); }
  bool ended() const { return player_.ended(); }
  Run& run() { return player_.run(); }
  const Run& run() const { return player_.run(); }

 private:
  void look();

  ReplayPlayer player_;
  Moments& moments_;
  double cost_ms_ = 0;  // of this thread, for the ticks since the last moment
};

}  // namespace gw
