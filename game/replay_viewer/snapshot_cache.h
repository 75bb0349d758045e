// Snapshots of a replay in memory, so that a seek to any tick starts from a near one.
//
//   ticks   0 ────── 240 ────── 480 ─── 640 ── 760 ── 870 ...
//                                       the same work lies between two, however dense the fight
//
// Thread-safe: playback and the prefetch thread share it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "game/session/run.h"

namespace gw {

class SnapshotCache {
 public:
  // The largest distance between two snapshots: in ticks, or in the time to compute them.
  struct Spacing {
    uint32_t ticks = 240;
    double cost_ms = 100;
  };
  static constexpr size_t kBudget_bytes = size_t(512) << 20;

  explicit SnapshotCache(size_t budget_bytes = kBudget_bytes) : SnapshotCache(budget_bytes, Spacing()) {}
  SnapshotCache(size_t budget_bytes, Spacing spacing) : budget_bytes_(budget_bytes), spacing_(spacing) {}

  // Whether a snapshot at this tick is due. cost_ms: the time to compute the ticks since the last one.
  bool wanted(uint32_t tick, double cost_ms) const;
  // Over the budget every second snapshot is dropped and the spacing doubled, repeatedly. The first always stays.
  void keep(RunSnapshot snapshot);

  bool has(uint32_t tick) const;
  // The last one at or before a tick; null when there is none.
  std::shared_ptr<const RunSnapshot> before(uint32_t tick) const;
  // Where a seek to a tick starts: lead_ticks before it, but at most kBack snapshots before the last one, which bounds
  // the work where ticks are slow. Null when there is none.
  std::shared_ptr<const RunSnapshot> start(uint32_t tick, uint32_t lead_ticks) const;
  static constexpr int kBack = 2;
  // The tick of the last snapshot; 0 when there is none.
  uint32_t lastTick() const;

  size_t count() const;
  size_t bytes() const;
  Spacing spacing() const;

 private:
  void thin();

  const size_t budget_bytes_;
  mutable std::mutex mutex_;
  Spacing spacing_;
  size_t bytes_ = 0;
  std::map<uint32_t, std::shared_ptr<const RunSnapshot>> kept_;  // by tick
};

// Its size in memory.
size_t bytesOf(const RunSnapshot& snapshot);

}  // namespace gw
