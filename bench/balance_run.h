// One game played by a bot, and what the balance of the game is judged by.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>

#include "game/sim/simulation.h"

namespace gw {

// Of each run only so much is watched for idleness and droughts: later the horde fills the view anyway.
inline constexpr uint32_t kWatched_ticks = 180 * kTicksPerSecond;
// Nothing has arrived before; the first drought is counted from here.
inline constexpr uint32_t kFirstKill_ticks = 3 * kTicksPerSecond;

struct BalanceRun {
  uint64_t seed = 0, score = 0;
  uint32_t ticks = 0;
  bool capped = false;  // still alive at the cap
  uint32_t contacts = 0;
  uint32_t drought_ticks = 0;  // longest time without a kill, of the watched ticks
  uint32_t idle_ticks = 0;     // of the watched ticks those in which few were in view and none were coming
  uint32_t peakAlive = 0, endAlive = 0, refused = 0;
  std::array<uint32_t, kMaxEnemyTypes> kills{};
  std::array<uint64_t, kMaxEnemyTypes> damage_us{};  // frame time that contact cost, by type

  uint64_t allKills() const { return std::accumulate(kills.begin(), kills.end(), uint64_t{0}); }
  uint32_t watched_ticks() const { return ticks < kWatched_ticks ? ticks : kWatched_ticks; }
};

// Plays config.seed on one thread until the end or the cap; nothing when `stop` says so before.
std::optional<BalanceRun> playForBalance(SimulationConfig config, uint32_t mostTicks,
                                         const std::function<bool()>& stop);

}  // namespace gw
