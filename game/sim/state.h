// The game on a device: buffers, and the view of them that kernels get.
//
// Positions are in cells (the NGrid); everything else is indexed by id and never moves. Two columns of
// cells take turns: maintain sorts `cells`, which holds the start of the tick and is what gathers search;
// integrate writes the end of the tick to `moved`, in the same arrangement. The thesis's two textures
// (force + energy, direction + mass) take turns likewise: think reads the front, writes the back.
#pragma once

#include "game/sim/behaviour/state_tables.h"
#include "game/sim/broad_phase.h"
#include "game/sim/entity_fields.h"
#include "game/sim/game_globals.h"
#include "game/sim/simulation.h"
#include "gpu/math/state_hash.h"
#include "gpu/primitives/scan_reduce.h"

namespace gw::GW_DEVICE {

// The device's copy of all tables.
struct Tables {
  uint64_t checksum;  // of all that follows
  Rules rules;
  Limits limits;
  MachineTable machines[kMachines];  // by Machine
  Mode mode;

  static const uint32_t kWords;  // of 32 bits, after the checksum
  GW_FN uint64_t wordHash(uint32_t w) const {
    return hashWord(kNobody - 1, w, (reinterpret_cast<const uint32_t*>(this) + 2)[w]);
  }
};
inline constexpr uint32_t Tables::kWords = (sizeof(Tables) - sizeof(uint64_t)) / 4;

struct View {
  const Tables* tables;
  GameGlobals* globals;
  TickScratch* scratch;
  TickReport* report;

  Cell *cells, *moved;
  uint32_t* cellOf;  // [id]
  Searches near;     // over cells
  Searches seen;     // over moved, before integrate overwrites it: last tick's start, what the bots see

  // By id (game/sim/entity_fields.h): state, and what is valid within one tick only.
#define GW_ONE(name, Type) Type* name;
#define GW_TWO(name, next, Type) Type *name, *next;
#define GW_BUFFER(name, Type, ...) Type* name;
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
  GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_ONE
#undef GW_TWO
#undef GW_BUFFER
  ScanView birthScan;  // free ids (low half), own births (high half)

  uint32_t capacity;
};

// The one of two alternating buffers with this address.
template <class T>
const Buffer<T>& sideOf(const Buffer<T> (&sides)[2], const T* d_data) {
  return sides[0].data() == d_data ? sides[0] : sides[1];
}
template <class T>
Buffer<T>& sideOf(Buffer<T> (&sides)[2], const T* d_data) {
  return sides[0].data() == d_data ? sides[0] : sides[1];
}

// Purposes of random numbers: the third word of a counter. Never reuse or renumber.
enum Purpose : uint32_t {
  kPurposePlace = 1,      // (tick, command, ., birth) where an enemy appears
  kPurposeCommand = 2,    // (tick, command) direction of a pattern
  kPurposeWander = 3,     // (tick, id) drift of the heading
  kPurposeScatter = 4,    // (tick, id) how bits fly apart
  kPurposeEndless = 5,    // (tick, group) type and pattern of endless waves
  kPurposeAutopilot = 6,  // (tick) aiming error
  // Cosmetic only, from here on.
  kPurposeParticles = 64,  // (tick, source, ., particle of its burst) way, speed, life and size of a spark
};

GW_FN bool isEnemy(uint32_t type) {
  return type < kMaxEnemyTypes;
}

// Harmless and untouchable: it only shows where it will be.
GW_FN bool isAnnounced(const View& v, uint32_t id) {
  return v.globals->tick - v.birthTick[id] < v.tables->rules.world.announced_ticks;
}

// Distances of an enemy's type from its middle.
GW_FN float reachOf(const EnemyRules& rules) {
  return rules.bounds == Bounds::circle
             ? rules.halfWidth_m
             : sqrtf(rules.halfWidth_m * rules.halfWidth_m + rules.halfHeight_m * rules.halfHeight_m);
}

class GameState {
 public:
  GameState(Queue& queue, const SimulationConfig& config);

  View view(uint32_t parity) const;  // parity of the tick
  const Limits& limits() const { return limits_; }
  Neighbourhood& neighbourhood() { return neighbourhood_; }
  Scan& birthScan() { return birthScan_; }

  Buffer<Tables> tables;
  Buffer<GameGlobals> globals;
  Buffer<TickScratch> scratch;
  Buffer<TickReport> report;
  Buffer<Cell> cells[2];
  Buffer<uint32_t> cellOf;
  // By id (game/sim/entity_fields.h).
#define GW_ONE(name, Type) Buffer<Type> name;
#define GW_TWO(name, next, Type) Buffer<Type> name[2];
#define GW_BUFFER(name, Type, ...) Buffer<Type> name;
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
  GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_ONE
#undef GW_TWO
#undef GW_BUFFER

 private:
  Limits limits_;
  Neighbourhood neighbourhood_;
  Scan birthScan_;
};

}  // namespace gw::GW_DEVICE
