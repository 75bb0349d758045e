#include "game/viewer/keeping_player.h"

#include <utility>

namespace gw {

KeepingPlayer::KeepingPlayer(ReplayPlayer player, Moments& moments, Clock_ms clock)
    : player_(std::move(player)), moments_(moments), clock_(std::move(clock)) {
  look();
}

void KeepingPlayer::playOne() {
  const double begun_ms = clock_();
  player_.playOne();
  cost_ms_ += clock_() - begun_ms;
  look();
}

void KeepingPlayer::restore(const RunMoment& moment) {
  player_.run().restore(moment);
  cost_ms_ = 0;
}

void KeepingPlayer::look() {
  if (moments_.has(tick())) {
    cost_ms_ = 0;
  } else if (moments_.wanted(tick(), cost_ms_)) {
    moments_.keep(player_.run().moment());
    cost_ms_ = 0;
  }
}

}  // namespace gw
