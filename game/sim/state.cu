#include <cmath>
#include <cstring>

#include "game/sim/state.h"

namespace gw::GW_DEVICE {
namespace {

// Speed that integrate never exceeds. Broad-phase radii of collide are widened by it, so raising it makes
// every gather there wider; lowering it clips knock-back.
constexpr float kFastestEnemy_mps = 24.0f;

Limits limitsOf(const SimulationConfig& config) {
  Limits limits{};
  const float scale = config.enemies > 8192 ? std::sqrt(float(config.enemies) / 8192.0f) : 1.0f;
  limits.width_m = config.rules.world.width_m * scale;
  limits.height_m = config.rules.world.height_m * scale;
  for (uint32_t t = 0; t < config.rules.enemyTypeCount; ++t) {
    limits.largestReach_m = larger(limits.largestReach_m, reachOf(config.rules.enemies[t]));
  }
  limits.fastestEnemy_mps = kFastestEnemy_mps;
  limits.enemies = config.enemies;
  limits.capacity = dimensionsOf(config).cells();
  return limits;
}

}  // namespace

GameState::GameState(Queue& queue, const SimulationConfig& config)
    : limits_(limitsOf(config)), neighbourhood_(queue, config, limits_.width_m, limits_.height_m) {
  const uint32_t n = limits_.capacity;
  birthScan_ = Scan(queue, n);
  tables = Buffer<Tables>(queue, 1);
  globals = Buffer<GameGlobals>(queue, 1);
  scratch = Buffer<TickScratch>(queue, 1);
  report = Buffer<TickReport>(queue, 1);
  cellOf = Buffer<uint32_t>(queue, n);
#define GW_ONE(name, Type) name = Buffer<Type>(queue, n);
#define GW_TWO(name, next, Type) \
  for (Buffer<Type> & side : name) side = Buffer<Type>(queue, n);
#define GW_BUFFER(name, Type, perId, ...) name = Buffer<Type>(queue, perId * size_t(n));
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
  GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_ONE
#undef GW_TWO
#undef GW_BUFFER

  const bool arranged = isArrangementState(config.gather);
  const std::vector<uint32_t> ids = arranged ? startArrangement(neighbourhood_.dimensions()) : std::vector<uint32_t>{};
  std::vector<Cell> empty(n);
  std::vector<uint32_t> own(n);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t id = arranged ? ids[i] : i;
    empty[i] = {kInfinity, kInfinity, id, kTypeNone};
    own[id] = i;
  }
  for (Buffer<Cell>& side : cells) {
    side = Buffer<Cell>(queue, n);
    side.upload(empty);
  }
  cellOf.upload(own);

  Tables host;
  std::memset(static_cast<void*>(&host), 0, sizeof host);
  host.rules = config.rules;
  host.limits = limits_;
  host.mode = config.mode;
  for (uint32_t m = 0; m < kMachines; ++m) host.machines[m] = tableOf(Machine(m));
  for (uint32_t w = 0; w < Tables::kWords; ++w) host.checksum += host.wordHash(w);
  tables.upload(&host, 1);

  GameGlobals start;
  start.seed = config.seed;
  start.ship.x = start.ship.previous_x = 0.5f * limits_.width_m;
  start.ship.y = start.ship.previous_y = 0.5f * limits_.height_m;
  start.frameTime_us = config.rules.budget.start_us;
  start.flushes = config.rules.flush.start;
  start.endlessPoints = config.rules.endless.points;
  if (config.mode == Mode::deadline) start.clock_ticks = config.rules.deadline.clock_ticks;
  if (config.mode == Mode::swarm) start.multiplierTenths = config.rules.swarm.multiplierTenths;
  globals.upload(&start, 1);

  if (!arranged) {
    for (Buffer<Cell>& side : cells) neighbourhood_.arrange(queue, side.data(), cellOf.data());
  }
  queue.synchronise();
}

View GameState::view(uint32_t parity) const {
  const uint32_t front = parity % 2, back = 1 - front;
  View v{};
  v.tables = tables.data();
  v.globals = globals.data();
  v.scratch = scratch.data();
  v.report = report.data();
  v.cells = cells[front].data();
  v.moved = cells[back].data();
  v.cellOf = cellOf.data();
  v.near = neighbourhood_.searches(v.cells);
  v.seen = neighbourhood_.searches(v.moved);
#define GW_ONE(name, Type) v.name = name.data();
#define GW_TWO(name, next, Type) v.name = name[front].data(), v.next = name[back].data();
#define GW_BUFFER(name, Type, ...) v.name = name.data();
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
  GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_ONE
#undef GW_TWO
#undef GW_BUFFER
  v.birthScan = birthScan_.view();
  v.capacity = limits_.capacity;
  return v;
}

}  // namespace gw::GW_DEVICE
