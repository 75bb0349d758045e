// The moments of a replay that are kept in memory, so that going to any tick means going on from a near one.
//
//   ticks   0 ────── 240 ────── 480 ─── 640 ── 760 ── 870 ...
//                                       the same work lies between two, however dense the fight
//
// Two threads use it: whoever watches, and the scout that runs ahead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "game/session/run.h"

namespace gw {

class Moments {
 public:
  // What may lie between two at most: so many ticks, or ticks that took so long to compute.
  struct Spacing {
    uint32_t ticks = 240;
    double cost_ms = 100;
  };
  static constexpr size_t kBudget_bytes = size_t(512) << 20;

  explicit Moments(size_t budget_bytes = kBudget_bytes) : Moments(budget_bytes, Spacing()) {}
  Moments(size_t budget_bytes, Spacing spacing) : budget_bytes_(budget_bytes), spacing_(spacing) {}

  // Whether a moment at this tick is worth its memory, when the ticks since the last one took so long.
  bool wanted(uint32_t tick, double cost_ms) const;
  // Over the budget every second one is dropped and the spacing doubled, as often as it takes. The first stays always.
  void keep(RunMoment moment);

  bool has(uint32_t tick) const;
  // The last one at or before a tick; null when there is none.
  std::shared_ptr<const RunMoment> before(uint32_t tick) const;
  // Where to begin on the way to a tick: so many ticks before it, but no more than kBack moments before the last one,
  // which bounds the work where ticks are slow. Null when there is none.
  std::shared_ptr<const RunMoment> start(uint32_t tick, uint32_t lead_ticks) const;
  static constexpr int kBack = 2;
  // The tick of the last one; 0 when there is none.
  uint32_t reach() const;

  size_t count() const;
  size_t bytes() const;
  Spacing spacing() const;

 private:
  void thin();

  const size_t budget_bytes_;
  mutable std::mutex mutex_;
  Spacing spacing_;
  size_t bytes_ = 0;
  std::map<uint32_t, std::shared_ptr<const RunMoment>> kept_;  // by tick
};

// What it takes in memory.
size_t bytesOf(const RunMoment& moment);

}  // namespace gw
