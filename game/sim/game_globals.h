// What logic owns: the globals of the game and last tick's totals. Plain data, laid out
// without padding (it is hashed and kept in snapshots word by word).
#pragma once

#include <cstdint>

#include "game/sim/behaviour/state_tables.h"
#include "game/sim/hash_fields.h"
#include "game/sim/input_record.h"
#include "game/sim/rules.h"

namespace gw {

inline constexpr uint32_t kNobody = 0xFFFFFFFFu;  // no entity
inline constexpr uint32_t kShotCapacity = 1024;   // shots and bits that fit beside the enemies
inline constexpr uint32_t kBitCapacity = 4096;

// Sums over all entities, made by settle and read by the next tick's logic.
struct Totals {
  uint64_t contact = 0;                     // of all that touched the ship the largest cost << 32 | ~id; 0: nothing did
  uint32_t occupied[16] = {};               // cells by type, those dying this tick included
  uint32_t kills[kMaxEnemyTypes] = {};      // died for score
  uint32_t bareKills[kMaxEnemyTypes] = {};  // died by the flush, for the bare value
  uint32_t dying = 0;                       // enemies in state dead: they leave in the next tick
  uint32_t bitsTaken = 0;
  uint32_t inView = 0;  // enemies within Rules::Idle's half extents of the ship
  uint32_t coming = 0;  // enemies announced or attacking
  uint32_t refusedBits = 0;
  uint32_t reserved = 0;
};

// Counts over all entities for the report only: the game does not depend on them.
struct Tally {
  uint32_t killSounds[kMaxEnemyTypes][3] = {};  // deaths to the left, in the middle, to the right of the ship
  Edges edges;
};

// Which enemies die without score.
enum Blast : uint32_t { kBlastNone, kBlastNear, kBlastAll };

struct Ship {
  float x = 0, y = 0, previous_x = 0, previous_y = 0;  // m
  float velocity_x = 0, velocity_y = 0;                // m/s
  float aim_rad = 0;
  uint32_t untouchable_ticks = 0;
  uint32_t fire_ticks = 0;  // until the next salvo
};

struct GameGlobals {
  uint64_t seed = 0;
  uint64_t score = 0;
  uint64_t kills = 0;
  Totals totals;
  Ship ship;
  uint32_t tick = 0;  // ticks completed
  uint32_t over = 0;  // an Ending
  uint32_t multiplierTenths = 10;
  uint32_t frameTime_us = 0;
  uint32_t bank_us = 0;
  uint32_t flushes = 0;
  uint32_t flushScores = 0;                           // thresholds of Rules::Flush passed
  float flush_x = 0, flush_y = 0, flushRadius_m = 0;  // radius 0: none running
  uint32_t blast = 0;                                 // a Blast, in the tick after a contact
  uint32_t blastId = kNobody;                         // the enemy that touched the ship
  uint32_t wave = 0;                                  // rows of the wave table started
  uint32_t waveClock_ticks = 0;
  uint32_t idle_ticks = 0;
  uint32_t endless = 0;      // endless waves started
  uint32_t clock_ticks = 0;  // left; deadline only
  uint32_t allAttack = 0;    // swarm: few are left, and all see the ship
  float endlessPoints = 0;
  float pace = 1.0f;  // enemies are so many times as fast as their types
  uint32_t contacts = 0;
  uint32_t bitsTaken = 0;
  uint32_t refused = 0;
  uint32_t peakEnemies = 0;
  InputRecord input{};  // of the tick before: a button goes down once, and a bot holds on to what it decided
  uint32_t killsByType[kMaxEnemyTypes] = {};
  uint32_t reserved = 0;
};
static_assert(sizeof(GameGlobals) % sizeof(uint64_t) == 0);

// A range of births that logic orders and spawn carries out.
struct Command {
  uint32_t type = 0, count = 0;
  uint32_t firstBirth = 0;  // births of earlier commands
  Pattern pattern = Pattern::ring;
  float x = 0, y = 0;    // the ship, or the muzzle
  float angle_rad = 0;   // direction of the pattern, of the salvo's middle shot
  float spread_rad = 0;  // shots only
  uint32_t hits = 0;     // shots only
};
inline constexpr uint32_t kMaxCommands = 64;

// What the stages of one tick pass to each other and to the report. Nothing of it outlives the tick.
struct TickScratch {
  InputRecord input{};  // the host's, or a bot's in its place
  uint32_t commandCount = 0;
  uint32_t births = 0;   // of all commands
  uint32_t bitRoom = 0;  // bits that still fit
  Command commands[kMaxCommands];
  uint32_t shotSounds = 0, waveSounds = 0, flushSounds = 0, overSounds = 0, contactSounds = 0;
  uint32_t contactType = kTypeNone, contactCost_us = 0;
  uint64_t fieldHashes[kHashFields] = {};
  // Made by settle, for the report only.
  uint64_t pops[3] = {};  // by side, of all scored kills the largest value << 32 | ~id; 0: none
  Tally tally;
  uint64_t longestStep2 = 0;  // bits of the largest squared step of an enemy (m^2), made by integrate
};

// Numbers that follow from the rules and the options, computed once on the host.
struct Limits {
  float width_m, height_m;  // the world, scaled to the number of enemies
  float largestReach_m;     // farthest corner of any enemy from its middle
  float fastestEnemy_mps;   // integrate never moves an enemy faster
  uint32_t enemies;         // how many fit
  uint32_t capacity;        // ids, and cells
};

}  // namespace gw
