// Playback of a replay with seeking to any tick. The state after a seek equals that of plain playback bit for bit,
// including score, effects and sparks.
//
// A seek takes longer than a frame, and the window must stay responsive: seek() sets the target, continueSeek() works
// towards it for some milliseconds, and the window handles its events in between.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "game/replay_viewer/caching_player.h"
#include "game/replay_viewer/prefetch_thread.h"

namespace gw {

class ReplayViewer {
 public:
  // The longest life of a spark (game/sim/draw/particles.cu). Sparks are not part of a snapshot, so a seek starts this
  // long before its target, or as long as SnapshotCache::start() allows.
  static constexpr uint32_t kSparks_ticks = 60;

  // The replay must outlive this. `prefetch` makes the second simulation for prefetching; null: no prefetching.
  ReplayViewer(const Replay& replay, std::unique_ptr<Simulation> simulation, PrefetchThread::Make prefetch,
               size_t budget_bytes = SnapshotCache::kBudget_bytes);

  // Sets the target, clamped to the replay; replaces an earlier one.
  void seek(uint32_t tick);
  // Relative to the seek target, or to the current tick when there is none.
  void seekBy(int64_t ticks);
  bool seeking() const { return target_.has_value(); }
  uint32_t seekTarget() const { return target_.value_or(tick()); }
  float seekProgress() const;  // 0 to 1
  // Works towards the target for this long. True when it is reached, or there is none.
  bool continueSeek(double budget_ms);

  // One tick of plain playback.
  void playOne() { player_.playOne(); }

  uint32_t tick() const { return player_.tick(); }
  uint32_t ticks() const { return replay_.ticks(); }
  bool ended() const { return player_.ended(); }
  // The tick up to which seeking is fast.
  uint32_t cachedTo() const { return std::max(cache_.lastTick(), playedTo_); }
  bool prefetched() const { return !prefetch_ || prefetch_->done(); }
  std::optional<uint32_t> differsFrom() const { return difference_.tick(); }

  Run& run() { return player_.run(); }
  const Run& run() const { return player_.run(); }
  const SnapshotCache& cache() const { return cache_; }

 private:
  void jump();

  const Replay& replay_;
  FirstDifference difference_;
  SnapshotCache cache_;
  CachingPlayer player_;
  std::optional<uint32_t> target_;
  uint32_t seekStart_ = 0;  // the tick where the seek started
  float progress_ = 0;
  uint32_t playedTo_ = 0;
  std::unique_ptr<PrefetchThread> prefetch_;  // last member: it references the others
};

}  // namespace gw
