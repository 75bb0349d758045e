#include "game/replay_viewer/keeping_player.h"

#include <time.h>

#include <utility>

namespace gw {

namespace {

// What a tick costs, not how long it waited for other programs.
double threadTime_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

}  // namespace

KeepingPlayer::KeepingPlayer(ReplayPlayer player, Moments& moments) : player_(std::move(player)), moments_(moments) {
  look();
}

void KeepingPlayer::playOne() {
  const double begun_ms = threadTime_ms();
  player_.playOne();
  cost_ms_ += threadTime_ms() - begun_ms;
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
