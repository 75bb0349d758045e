// The numbers of the game, as plain data. They come from assets/*.toml (game/tables reads them), are
// uploaded once, and are embedded in every replay. Metres, seconds, microseconds, ticks of 1/60 s.
#pragma once

#include <cstdint>

#include "game/sim/behaviour/state_tables.h"
#include "render/sprite_shapes.h"

namespace gw {

inline constexpr uint32_t kTicksPerSecond = 60;
inline constexpr float kTick_s = 1.0f / 60.0f;

inline constexpr uint32_t kMaxEnemyTypes = 8;
inline constexpr uint32_t kMaxShotLevels = 8;
inline constexpr uint32_t kMaxWaves = 64;
inline constexpr uint32_t kMaxGroups = 4;  // groups per wave
inline constexpr uint32_t kMaxFlushScores = 16;
inline constexpr uint32_t kMaxNameLength = 15;

// Type tags as they stand in Cell::type. Enemy types come first, in table order.
enum EntityType : uint32_t {
  kTypeShot = 8,
  kTypeBit = 9,
  kTypeCount = 10,
  kTypeNone = 15,  // a dead cell
};

enum class Bounds : uint32_t { circle = 0, rectangle = 1 };
enum class Pattern : uint32_t { ring, spiral, cluster, corners, wall, rain, river, count };

struct EnemyRules {
  char name[kMaxNameLength + 1];
  Machine machine;
  Bounds bounds;
  float halfWidth_m, halfHeight_m;  // circle: both are the radius
  float speed_mps;
  float sight_m;   // one distance, to the ship; lost again at sightLost times it
  float vision_m;  // the NGrid radius
  float energy;
  float mass;
  uint32_t contact_us;           // frame time that touching the ship costs
  uint32_t value;                // score before the multiplier
  uint32_t bits;                 // born at its death
  uint32_t avoidCooldown_ticks;  // group and tricky: between two dodges; 0 for kamikazes
  Shape shape;                   // how it is drawn (render/sprite_shapes.h)
  uint32_t colour;               // 0xRRGGBB
};

struct ShotLevel {
  uint32_t fromTenths;  // multiplier, in tenths, from which this level holds
  uint32_t count;
  float spread_rad;  // between neighbouring shots; 0: parallel, side by side
  uint32_t every_ticks;
  uint32_t hits;  // enemies a shot passes through, the last one included
};

struct WaveGroup {
  uint32_t type;
  uint32_t count;
  Pattern pattern;
};

struct Wave {
  uint32_t at_ticks;
  uint32_t groupCount;
  WaveGroup groups[kMaxGroups];
};

struct Rules {
  struct World {
    float width_m, height_m;   // for at most 8,192 enemies; scaled by sqrt(enemies / 8192) above
    float spawnClearance_m;    // no enemy appears nearer to the ship
    uint32_t announced_ticks;  // harmless and untouchable after birth
  } world;

  struct Ship {
    float radius_m, speed_mps;
    float response;  // share of the gap to the stick's velocity closed per tick, 0..1
    uint32_t untouchable_ticks;
    float blast_m;     // after contact everything weak this near dies without score
    float weakEnergy;  // full energy at most this is weak
  } ship;

  struct Budget {
    uint32_t start_us, limit_us;       // 60 FPS and 12 FPS
    uint32_t bitReturns_us;            // a bit gives this back...
    uint32_t bankFill_us, bankMax_us;  // ...out of a bank that fills this much per tick, up to bankMax_us
    uint32_t hitStop_ms;               // host pacing only
  } budget;

  struct Shot {
    float speed_mps, radius_m, damage;
    uint32_t life_ticks;
    float knockBack_mps;  // divided by the victim's mass
    uint32_t levelCount;
    ShotLevel levels[kMaxShotLevels];
  } shot;

  struct Bit {
    uint32_t life_ticks;
    float speed_mps, attract_m, take_m;
    uint32_t multiplierTenths;
  } bit;

  struct Flush {
    uint32_t start, most;
    float speed_mps, reach_m;
    uint32_t untouchable_ticks;
    uint32_t scoreCount;
    uint64_t scores[kMaxFlushScores];  // one more flush when the score passes each
  } flush;

  struct Steering {
    float response;         // share of the gap to the wished velocity closed per tick
    float wanderSpeed;      // share of the type's speed
    float wanderDrift_rad;  // most the heading drifts per tick
    float wanderToShip;     // weight of the ship's direction while wandering
    float damagedSpeed;     // a damaged kamikaze is this much faster
    float separation_mps;   // most that overlapping bodies are pushed
    float press_mps;        // pushes that cancel: at this sum of them a body keeps half of its velocity
    float sightLost;        // sight is lost at this multiple of it

    // Group and tricky. Weights are those of unit vectors, the way ahead having weight 1.
    float cohesion, alignment;  // grouping: towards the middle of its own type, along their heading
    float attackAlignment;      // group, attacking
    float sideways;             // tricky, attacking: across the line to the ship...
    float sidewaysBeyond_m;     // ...while farther than this from it

    // Avoiding a shot that is at most `threat_m` away and would pass within its radius + `threatMargin_m`.
    float threat_m, threatMargin_m;
    float avoid_mps, avoidResponse;
    uint32_t avoid_ticks;

    // Tricky, escaping: from under `escapeBelow` of its energy until `recoveredAt` of it.
    float escapeBelow, recoveredAt;
    float recover_per_s;  // energy
    float escapeSpeed;    // share of the type's speed
    float escapeWall_m;   // nearer to a wall than this it flies along it
  } steering;

  struct Endless {
    uint32_t from_ticks, every_ticks;
    float points, growth;
    float paceGrowth, paceMost;  // each wave makes all enemies so many times as fast as before, up to the most
    float price[kMaxEnemyTypes];
    uint32_t chance_percent[kMaxEnemyTypes];
  } endless;

  struct Idle {
    uint32_t fewerThan;  // enemies within the half extents below
    float halfWidth_m, halfHeight_m;
    uint32_t wait_ticks;  // the next wave then starts this soon
    uint32_t pays;        // times the multiplier, per second saved
  } idle;

  struct Deadline {
    uint32_t clock_ticks;
    uint32_t waveRate;             // the timetable runs so many times as fast
    uint32_t contactTicks_per_ms;  // of the clock, per ms that a contact would have cost
  } deadline;

  struct Swarm {
    float clearance_m;  // of the ship, for all at once
    uint32_t multiplierTenths;
    float attackShare;  // with at most this share left, all attack
  } swarm;

  uint32_t enemyTypeCount;
  EnemyRules enemies[kMaxEnemyTypes];
  uint32_t waveCount;
  Wave waves[kMaxWaves];
};

}  // namespace gw
