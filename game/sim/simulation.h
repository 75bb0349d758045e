// The one seam between the host and the game on a device. Host code knows this header and nothing of
// the kernels behind it; each device namespace makes its own Simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/sim/behaviour/state_tables.h"
#include "game/sim/draw/particle.h"
#include "game/sim/entity_fields.h"
#include "game/sim/hash_fields.h"
#include "game/sim/input_record.h"
#include "game/sim/rules.h"
#include "gpu/devices/device_error.h"
#include "gpu/exec/exec_options.h"
#include "render/sprite_vertex.h"

namespace gw {

enum class Mode : uint32_t { arcade, deadline, swarm, practice };
// How a run ended.
enum class Ending : uint32_t { none, frameRate, timeUp, cleared };
enum class BroadPhase : uint32_t { ngrid, grid, gridHashed, bruteForce };
// How the NGrid is searched and kept in order. Exact gathers cannot change the game, nor can the sort they go with:
// bitonic, full or frozen. With an inexact one, by bitonic or odd-even sort, the arrangement of the cells is part of
// the state: hashed, and kept in snapshots and replays.
enum class Gather : uint32_t { exact, adaptive, fixed };
enum class Sort : uint32_t { bitonic, oddEven, full, frozen };
// The fastest that was measured (docs/results/ngrid-performance.md); of windows the thesis's.
constexpr Sort usualSort(Gather gather) {
  return gather == Gather::exact ? Sort::frozen : Sort::bitonic;
}
enum class Autopilot : uint32_t { none, novice, expert };

struct SimulationConfig {
  Rules rules{};
  uint64_t seed = 1;
  Mode mode = Mode::arcade;
  uint32_t enemies = 8192;  // how many live enemies fit
  Autopilot autopilot = Autopilot::none;
  Gather gather = Gather::exact;
  std::optional<Sort> sort{};  // none: the usual one of the gather
  Sort sortInUse() const { return sort.value_or(usualSort(gather)); }

  // Sparks of events, for drawing. They cost a little of every tick, and no bit of the game
  // depends on them.
  bool particles = false;

  // How it is computed. None of this changes a single bit of the game.
  BroadPhase broadPhase = BroadPhase::ngrid;
  uint32_t threads = 0;  // cpu device: 0 takes one per processor that it may use
  VisitOrder order = VisitOrder::forward;
  bool protectMemory = false;  // cpu device: device memory is unreadable outside launches and copies
  uint32_t blockSize = 128;    // cuda device: threads per block
  bool checkLaunches = ExecOptions{}.checkLaunches;  // cuda device: wait for and check every launch; no graph
};

// Sound events of one tick, counted by kind and by side (left, middle, right of the ship).
enum class SoundEvent : uint32_t { shot, contact, bit, wave, flush, over, count };
inline constexpr uint32_t kPans = 3;

// A kill worth showing: the most valuable of a tick on each side of the ship.
struct Pop {
  float x = 0, y = 0;   // m
  uint32_t points = 0;  // its value times the multiplier; 0: none
};

// What the host receives of one tick; everything else stays on the device.
struct TickReport {
  uint32_t tick = 0;  // ticks completed, counting from 1
  uint32_t over = 0;  // not 0 from the tick in which the run ended
  Ending ending = Ending::none;
  uint64_t hash = 0;  // of the whole simulated state after this tick: the sum of
  uint64_t fieldHashes[kHashFields] = {};
  InputRecord input{};  // as used: the autopilot's own when one is on
  float ship_x = 0, ship_y = 0, shipPrevious_x = 0, shipPrevious_y = 0;
  float aim_rad = 0;
  uint64_t score = 0;
  uint64_t kills = 0;
  uint32_t multiplierTenths = 10;
  uint32_t frameTime_us = 0;  // the budget: over at Rules::Budget::limit_us
  uint32_t bank_us = 0;
  uint32_t flushes = 0;
  float flush_x = 0, flush_y = 0, flushRadius_m = 0;  // radius 0: none running
  uint32_t untouchable_ticks = 0;
  uint32_t clock_ticks = 0;                   // left; deadline only
  uint32_t wave = 0;                          // waves started
  float pace = 1.0f;                          // enemies are so many times as fast as their types
  uint32_t enemies = 0, shots = 0, bits = 0;  // alive
  uint32_t enemiesInView = 0;                 // within Rules::Idle's half extents of the ship
  // NGrid of an exact gather: the rows' summed heights by what they were after the last full sort; 0: they have none.
  // No part of the game.
  float rowsWidened = 0.0f;
  uint32_t idle_ticks = 0;  // for so long the next wave has been waited for; see Rules::Idle
  uint32_t peakEnemies = 0;
  uint32_t refused = 0;              // births that did not fit, over the whole run
  uint32_t bitsTaken = 0;            // over the whole run
  uint32_t contacts = 0;             // over the whole run
  uint32_t contactType = kTypeNone;  // what touched the ship this tick, or kTypeNone
  uint32_t contactCost_us = 0;
  uint32_t killsByType[kMaxEnemyTypes] = {};  // over the whole run
  Edges edges;                                // state changes this tick
  uint16_t sounds[uint32_t(SoundEvent::count)][kPans] = {};
  uint16_t killSounds[kMaxEnemyTypes][kPans] = {};  // deaths, those without score too
  Pop pops[kPans];
};

// The whole simulated state in canonical form: equal states give equal bytes on every device.
struct Snapshot {
  std::vector<uint8_t> globals;        // the globals of the game
  std::vector<EntityRecord> entities;  // live ones, by ascending id
  // The id in each cell, the empty ones included. Only of games with an inexact gather; an exact one takes no
  // notice of it, and an inexact one that is given none arranges the entities afresh.
  std::vector<uint32_t> arrangement;
};

// What sprites are coloured by: their type, or the row of the grid that they stand in, which shows how the grid lies in
// the world.
enum class Colouring : uint32_t { types, rows };

// Which part of the world the draw list covers.
struct DrawView {
  float centre_x, centre_y, halfWidth_m, halfHeight_m;
  Colouring colouring = Colouring::types;  // of all but the ship
};

// Where the draw list goes: addresses that the device can write (a persistent map on cpu, a mapped
// interop resource on cuda).
struct DrawTarget {
  SpriteVertex* vertices = nullptr;
  uint32_t vertexCapacity = 0;
  DrawArraysCommand* command = nullptr;
};

struct ParticleTarget {
  ParticleVertex* vertices = nullptr;
  uint32_t vertexCapacity = 0;
  DrawArraysCommand* command = nullptr;
};

struct StageTime {
  std::string name;
  double total_ms = 0;
  uint64_t calls = 0;
};

struct CandidateCount {
  uint64_t tested = 0;    // pair tests, the entity itself not counted
  uint64_t found = 0;     // of those, neighbours
  uint64_t entities = 0;  // enemies that searched
  double search_ms = 0;   // what searching took, without adding up
};

// Live counts, made on the device.
struct Census {
  uint32_t enemies[kMaxEnemyTypes] = {};  // by type; the announced ones too, the dying ones not
  uint32_t shots = 0, bits = 0;
  // Entities in the grid at the last search for neighbours; of those, for an NGrid, how many stood before their
  // predecessor on a row or a column.
  uint32_t searched = 0;
  std::optional<uint32_t> misaligned{};
};

// What a simulation is, for as long as its device lives.
struct SimulationFacts {
  SimulationConfig config;  // what it was made of: enough to make the same game again
  uint32_t capacity = 0;    // ids
  float worldWidth_m = 0, worldHeight_m = 0;
  std::string deviceName;
  bool onCuda = false;  // draw targets are addresses of the cuda device; else of the host
};

class Inspection;

class Simulation {
 public:
  virtual ~Simulation() = default;

  // Queues one tick. At most kTicksInFlight may be queued before report() is called for the oldest.
  virtual void tick(const InputRecord& input) = 0;
  // The report of the oldest tick not yet read; waits for it. Throws std::logic_error when none is queued.
  virtual TickReport report() = 0;

  virtual Snapshot snapshot() = 0;
  // Restores the state; the next tick continues from it. Throws std::invalid_argument on one that does
  // not fit (an id past the capacity, ids out of order, globals of another size, an arrangement that does not
  // hold every id once).
  virtual void restore(const Snapshot& snapshot) = 0;

  // Writes the sprites within the view, the most dangerous last, and the instance count; done when it returns. Not a
  // tick stage.
  virtual void drawList(const DrawView& view, const DrawTarget& target) = 0;

  // Writes the streaks of the particles within the view, the newest first, as they are when this many ticks
  // (a share of one, and more once the run is over) have passed since the last tick. Leaves the target
  // alone when the simulation was made without particles.
  virtual void particleList(const DrawView& view, float sinceTick_ticks, const ParticleTarget& target) = 0;
  // All particles in the ring, the newest last; for tests that compare devices.
  virtual std::vector<Particle> particles() const = 0;

  // The live enemy nearest to a place, within radius_m of it, with all its fields.
  virtual std::optional<EntityRecord> inspect(float x, float y, float radius_m) = 0;

  // How many pairs the broad phase tests when every live enemy gathers within its vision.
  virtual CandidateCount countCandidates() = 0;
  // Not a tick stage; changes nothing.
  virtual Census census() = 0;

  virtual void enableStageTimes(bool on) = 0;
  virtual bool timesStages() const = 0;
  virtual std::vector<StageTime> stageTimes() const = 0;

  // Every value of the game (game/sim/debug/inspection.h); valid as long as its device.
  virtual Inspection& inspection() = 0;

  // Kernels of the last tick that was put together. Copies of the records and events are nodes beside them.
  virtual uint32_t launchesPerTick() const = 0;

  virtual size_t deviceBytes() const = 0;  // of the device's memory, held now

  virtual const SimulationFacts& facts() const = 0;
  const SimulationConfig& config() const { return facts().config; }
  uint32_t capacity() const { return facts().capacity; }
  float worldWidth_m() const { return facts().worldWidth_m; }
  float worldHeight_m() const { return facts().worldHeight_m; }
  const std::string& deviceName() const { return facts().deviceName; }
  bool onCuda() const { return facts().onCuda; }

  // Gives up the device, for a reason that its users found; throws DeviceError with that reason when nothing can take
  // its place (game/session/failover.h).
  virtual void dropDevice(const std::string& why);
  // Why an earlier device was given up; empty: none was.
  virtual std::string dropped() const { return {}; }
  // Before GL calls: workers of the cpu device stop spinning, so that the driver's threads get the cores.
  virtual void park() = 0;

  static constexpr uint32_t kTicksInFlight = 4;
};

inline void Simulation::dropDevice(const std::string& why) {
  throw DeviceError(why);
}

namespace cpu {
std::unique_ptr<Simulation> makeSimulation(const SimulationConfig& config);
}
#ifdef GW_HAVE_CUDA
namespace cuda {
std::unique_ptr<Simulation> makeSimulation(const SimulationConfig& config);
}
#endif

}  // namespace gw
