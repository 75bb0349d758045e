#include "bench/balance_run.h"

#include <algorithm>

namespace gw {

namespace {

void add(BalanceRun& run, uint32_t& lastKill_ticks, const TickReport& report) {
  if (report.tick <= kWatched_ticks) {
    if (report.kills > run.allKills() || report.tick <= kFirstKill_ticks) lastKill_ticks = report.tick;
    run.drought_ticks = std::max(run.drought_ticks, report.tick - lastKill_ticks);
    run.idle_ticks += report.idle_ticks > 0;
  }
  run.ticks = report.tick;
  run.score = report.score;
  run.contacts = report.contacts;
  run.peakAlive = report.peakEnemies;
  run.endAlive = report.enemies;
  run.refused = report.refused;
  std::copy_n(report.killsByType, kMaxEnemyTypes, run.kills.begin());
  if (report.contactType < kMaxEnemyTypes) run.damage_us[report.contactType] += report.contactCost_us;
}

}  // namespace

std::optional<BalanceRun> playForBalance(SimulationConfig config, uint32_t mostTicks,
                                         const std::function<bool()>& stop) {
  config.threads = 1;
  const auto simulation = cpu::makeSimulation(config);
  BalanceRun run;
  run.seed = config.seed;
  uint32_t queued = 0, lastKill_ticks = 0;
  bool over = false;
  while (!over && run.ticks < mostTicks) {
    if (stop()) return std::nullopt;
    while (queued < mostTicks && queued - run.ticks < Simulation::kTicksInFlight) {
      simulation->tick({});
      ++queued;
    }
    const TickReport report = simulation->report();
    add(run, lastKill_ticks, report);
    over = report.over != 0;
  }
  run.capped = !over;
  return run;
}

}  // namespace gw
