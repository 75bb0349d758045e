#include "game/replay_viewer/scout.h"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>

#include "gpu/exec/float_state.h"

namespace gw {

namespace {

void stepBack() {
  constexpr int kLowest = 19;
  // Of this thread only; where it is not allowed the scout is merely less polite.
  (void)setpriority(PRIO_PROCESS, id_t(gettid()), kLowest);
}

}  // namespace

Scout::Scout(const Replay& replay, FirstDifference& difference, Moments& moments, Make make) {
  thread_ = std::thread([this, &replay, &difference, &moments, make = std::move(make)] {
    try {
      work(replay, difference, moments, make);
    } catch (const std::exception&) {
      // No memory for a second game, say: whoever watches plays every tick himself then, which he can.
    }
    done_ = true;
  });
}

Scout::~Scout() {
  stop_ = true;
  thread_.join();
}

void Scout::work(const Replay& replay, FirstDifference& difference, Moments& moments, const Make& make) {
  stepBack();
  setFloatState();
  KeepingPlayer player(ReplayPlayer(replay, make(), difference), moments);
  constexpr uint32_t kWorthIt_ticks = 60;
  while (!stop_ && !player.ended()) {
    // Whoever watches at 16 times the speed may be ahead; what he has seen needs no scout.
    if (moments.reach() > player.tick() + kWorthIt_ticks) player.restore(*moments.before(moments.reach()));
    player.playOne();
  }
}

}  // namespace gw
