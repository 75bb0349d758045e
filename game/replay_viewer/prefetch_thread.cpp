#include "game/replay_viewer/prefetch_thread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>

#include "gpu/exec/float_state.h"

namespace gw {

namespace {

void lowerPriority() {
  constexpr int kLowest = 19;
  // Of this thread only. Where it is not permitted the thread competes with playback, which is harmless.
  (void)setpriority(PRIO_PROCESS, id_t(gettid()), kLowest);
}

}  // namespace

PrefetchThread::PrefetchThread(const Replay& replay, FirstDifference& difference, SnapshotCache& cache, Make make) {
  thread_ = std::thread([this, &replay, &difference, &cache, make = std::move(make)] {
    try {
      work(replay, difference, cache, make);
    } catch (const std::exception&) {
      // E.g. no memory for a second simulation: playback works without prefetching.
    }
    done_ = true;
  });
}

PrefetchThread::~PrefetchThread() {
  stop_ = true;
  thread_.join();
}

void PrefetchThread::work(const Replay& replay, FirstDifference& difference, SnapshotCache& cache, const Make& make) {
  lowerPriority();
  setFloatState();
  CachingPlayer player(ReplayPlayer(replay, make(), difference), cache);
  constexpr uint32_t kWorthIt_ticks = 60;
  while (!stop_ && !player.ended()) {
    // Playback at 16 times the speed may be ahead: skip what it has cached already.
    if (cache.lastTick() > player.tick() + kWorthIt_ticks) player.restore(*cache.before(cache.lastTick()));
    player.playOne();
  }
}

}  // namespace gw
