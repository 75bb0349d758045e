// Plays a replay tick by tick and compares every hash: common to watching, prefetching and rendering a film.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "game/replay/replay.h"
#include "game/session/run.h"

namespace gw {

// The first tick whose hash differs from the recorded one. Thread-safe.
class FirstDifference {
 public:
  void compare(uint32_t tick, uint64_t computed, uint64_t recorded) {
    if (computed == recorded) return;
    uint32_t first = first_.load();
    while (tick < first && !first_.compare_exchange_weak(first, tick)) {
    }
  }
  std::optional<uint32_t> tick() const {
    const uint32_t first = first_.load();
    return first == kNone ? std::nullopt : std::optional(first);
  }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;
  std::atomic<uint32_t> first_{kNone};
};

class ReplayPlayer {
 public:
  // Replay and difference must outlive this; the simulation has not ticked yet.
  ReplayPlayer(const Replay& replay, std::unique_ptr<Simulation> simulation, FirstDifference& difference)
      : replay_(replay), difference_(difference), run_(std::move(simulation), std::nullopt) {}

  uint32_t tick() const { return run_.last().tick; }
  // The replay has no more inputs, or the run is over.
  bool ended() const { return tick() >= replay_.ticks() || run_.over(); }

  // Plays to this tick or the end, keeping the device's queue full.
  void playTo(uint32_t tick);
  void playOne() { playTo(tick() + 1); }

  Run& run() { return run_; }
  const Run& run() const { return run_; }

 private:
  const Replay& replay_;
  FirstDifference& difference_;
  Run run_;
};

}  // namespace gw
