// A player of a replay that leaves moments behind as it goes.
#pragma once

#include <functional>

#include "game/viewer/moments.h"
#include "game/viewer/replay_player.h"

namespace gw {

class KeepingPlayer {
 public:
  using Clock_ms = std::function<double()>;

  // `clock` measures what ticks cost.
  KeepingPlayer(ReplayPlayer player, Moments& moments, Clock_ms clock);

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
  Clock_ms clock_;
  double cost_ms_ = 0;  // of the ticks since the last moment
};

}  // namespace gw
