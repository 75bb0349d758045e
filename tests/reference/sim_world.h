// The game once more, for the tests: plain, slow, on the host, written from the rules. Every function here
// does what one stage has to do, by loops over all entities; it shares with the kernels only plain data
// and, where bits must match, the exact maths and the random numbers.
#pragma once

#include <vector>

#include "game/sim/game_globals.h"
#include "game/sim/simulation.h"
#include "gpu/math/plain_types.h"

namespace gw::naive {

struct Entity : EntityRecord {
  bool taken = false;      // a bit that the ship collected in this tick
  bool died = false;       // became dead in this tick
  bool transited = false;  // changed its state in this tick
  bool gone = false;       // leaves at the end of this tick unless it hits a victim
};

struct World {
  Rules rules{};
  Limits limits{};
  Mode mode = Mode::arcade;
  GameGlobals globals;
  std::vector<Entity> entities;  // by ascending id

  // What a tick's logic asks for, in order.
  InputRecord input{};
  std::vector<Command> commands;

  // Puts an entity at its place among the others; ids must differ.
  Entity& add(const EntityRecord& record);
  Entity& byId(uint32_t id);
  std::vector<EntityRecord> records() const;

  bool isEnemy(const Entity& e) const { return e.type < kMaxEnemyTypes; }
  const EnemyRules& rulesOf(const Entity& e) const { return rules.enemies[e.type]; }
  bool isAnnounced(const Entity& e) const { return globals.tick - e.birthTick < rules.world.announced_ticks; }
};

void logic(World& world);  // reads world.input
void spawn(World& world);
void think(World& world);
void integrate(World& world);
void collide(World& world);
void settle(World& world);

// All of them. Does nothing once the game is over.
void tick(World& world, const InputRecord& input);

// Parts that tests also use alone.
enum class Mind : uint32_t { wandering, grouping, attacking, avoiding, escaping, checkingEnergy, dead };
struct Facts {
  bool damaged = false, energyGone = false, energyLow = false, recovered = false, avoided = false, shotComing = false,
       seesShip = false, lostShip = false;
  bool company = false, alone = false;  // neither: it did not ask
};
Mind nextMind(Machine machine, Mind mind, const Facts& facts);
// Earliest time in 0..1 at which a circle at (x, y), moving by (dx, dy), touches the body at the origin; 2: never.
float meeting(float x, float y, float dx, float dy, float radius, const EnemyRules& body);
// Where the k-th of a command is born.
Float2 birthPlace(const World& world, const Command& command, uint32_t index, uint32_t k);

}  // namespace gw::naive
