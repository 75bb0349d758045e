// The machines' tables, edge by edge, against RULES.md read a second time (tests/reference/sim_think.cpp).
#include <gtest/gtest.h>

#include "game/sim/behaviour/behaviour.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kSets = 1u << kConditionCount;
constexpr Machine kAllMachines[] = {Machine::kamikaze, Machine::group, Machine::tricky};

bool hasBit(uint32_t set, Condition condition) {
  return (set & condition) != 0;
}

TEST(think_table, all_machines_all_states_and_all_sets_of_conditions) {
  for (const Machine machine : kAllMachines) {
    for (uint32_t state = 0; state < kStates; ++state) {
      for (uint32_t set = 0; set < kSets; ++set) {
        if (hasBit(set, kOwnKind) && hasBit(set, kAlone)) continue;  // neither holds when it is not its turn to ask
        naive::Facts facts;
        facts.damaged = hasBit(set, kDamaged);
        facts.energyGone = hasBit(set, kEnergyGone);
        facts.energyLow = hasBit(set, kEnergyLow);
        facts.recovered = hasBit(set, kRecovered);
        facts.avoided = hasBit(set, kAvoided);
        facts.shotComing = hasBit(set, kShotComing);
        facts.seesShip = hasBit(set, kSeesShip);
        facts.lostShip = hasBit(set, kLostShip);
        facts.company = hasBit(set, kOwnKind);
        facts.alone = hasBit(set, kAlone);
        if (facts.seesShip && facts.lostShip) continue;
        ASSERT_EQ(uint32_t(cpu::nextState(tableOf(machine), State(state), set)),
                  uint32_t(naive::nextMind(machine, naive::Mind(state), facts)))
            << nameOf(machine) << ", " << nameOf(State(state)) << " with conditions " << set;
      }
    }
  }
}

// A row that an earlier one always hides would be dead data.
TEST(think_table, every_row_is_the_first_to_apply_somewhere) {
  for (const Machine machine : kAllMachines) {
    const MachineTable& table = tableOf(machine);
    for (uint32_t row = 0; row < table.count; ++row) {
      bool reached = false;
      for (uint32_t state = 0; state < kStates; ++state) {
        for (uint32_t set = 0; set < kSets; ++set) {
          const auto applies = [&](const Transition& t) {
            return (t.from >> state & 1u) && (t.needs & set) == t.needs;
          };
          bool earlier = false;
          for (uint32_t i = 0; i < row; ++i) earlier = earlier || applies(table.rows[i]);
          reached = reached || (!earlier && applies(table.rows[row]));
        }
      }
      EXPECT_TRUE(reached) << nameOf(machine) << ", row " << row;
    }
  }
}

// Where an enemy stands relative to its sight, and what follows from that.
struct Place {
  const char* name;
  float sights;  // distance to the ship, in multiples of the sight
  bool sees, lost;
};
constexpr Place kPlaces[] = {{"near", 0.5f, true, false},
                             {"at the edge", 1.0f, true, false},
                             {"between", 1.125f, false, false},
                             {"at the far edge", 1.25f, false, false},
                             {"away", 1.5f, false, true}};
struct Health {
  const char* name;
  float share;
  bool gone, low, recovered;
};
constexpr Health kHealths[] = {{"whole", 1.0f, false, false, true},
                               {"weak", 0.375f, false, true, false},
                               {"half", 0.5f, false, false, false},
                               {"spent", 0.0f, true, true, false}};

// One enemy of a type in every situation that its machine tells apart.
void checkType(uint32_t type) {
  StageFixture fixture;
  const EnemyRules& rules = fixture.rules().enemies[type];
  for (uint32_t state = 0; state < kStates; ++state) {
    for (const Place& place : kPlaces) {
      for (const Health& health : kHealths) {
        for (uint32_t set = 0; set < 64; ++set) {
          const bool hit = set & 1, kin = set & 2, shot = set & 4, cooling = set & 8, avoided = set & 16;
          const bool turn = set & 32;
          if (avoided && State(state) != State::avoiding) continue;
          naive::World world = fixture.emptyWorld();
          world.globals.tick = turn ? kLateTick + 3 : kLateTick;  // with id 5
          EntityRecord e = enemyAt(fixture.rules(), 5, type, world.globals.ship.x + place.sights * rules.sight_m,
                                   world.globals.ship.y);
          e.state = state;
          e.energy = rules.energy * health.share;
          e.flags = hit ? uint32_t(kFlagHit) : 0u;
          e.cooldown = cooling ? 2 : 1;  // it counts down before it is asked
          e.timer = avoided ? 1 : State(state) == State::avoiding ? 2 : 0;
          world.add(e);
          if (kin) world.add(enemyAt(fixture.rules(), 6, type, e.x, e.y + 3.0f));
          if (shot) world.add(shotAt(fixture.rules(), 7, e.x - 5.0f, e.y + 0.25f, 0.0f));
          fixture.begin(world);
          cpu::think(fixture.queue(), fixture.view());

          naive::Facts facts;
          facts.damaged = hit;
          facts.energyGone = health.gone;
          facts.energyLow = health.low;
          facts.recovered = health.recovered;
          facts.avoided = avoided;
          facts.shotComing = shot && !cooling;
          facts.seesShip = place.sees;
          facts.lostShip = place.lost;
          const bool asks = turn || State(state) == State::attacking;
          facts.company = asks && kin;
          facts.alone = asks && !kin;
          const State wanted = State(naive::nextMind(rules.machine, naive::Mind(state), facts));
          const EntityRecord after = fixture.entities(true, false).at(0);
          const uint32_t event = fixture.events().at(5);
          SCOPED_TRACE(std::string(rules.name) + ", " + nameOf(State(state)) + ", " + place.name + ", " + health.name +
                       ", set " + std::to_string(set));
          ASSERT_EQ(after.state, uint32_t(wanted));
          const bool moved = wanted != State(state);
          ASSERT_EQ(event & kEventTransition, moved ? kEventTransition : 0u);
          ASSERT_EQ(moved ? event >> kEventFromShift : state, state);
          ASSERT_EQ(event & kEventDied, wanted == State::dead && moved ? kEventDied : 0u);
          // Only the check takes notice of a hit, so that no hit is ever lost.
          ASSERT_EQ(after.flags & kFlagHit, hit && wanted != State::checkingEnergy ? kFlagHit : 0u);
        }
      }
    }
  }
}

TEST(think_table, the_kernel_finds_every_condition_of_a_kamikaze) {
  checkType(1);
}
TEST(think_table, the_kernel_finds_every_condition_of_a_group) {
  checkType(4);
}
TEST(think_table, the_kernel_finds_every_condition_of_a_tricky_one) {
  checkType(6);
}

TEST(think_table, two_hits_in_a_row_are_checked_twice) {
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  world.globals.tick = kLateTick;
  EntityRecord e = enemyAt(fixture.rules(), 0, 1, world.globals.ship.x + 10.0f, world.globals.ship.y);
  e.state = uint32_t(State::checkingEnergy);
  e.flags = kFlagHit;
  world.add(e);
  for (const State wanted : {State::checkingEnergy, State::attacking}) {
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    const EntityRecord after = fixture.entities(true, false).at(0);
    EXPECT_EQ(after.state, uint32_t(wanted));
    world.entities.clear();
    world.add(after);
  }
}

}  // namespace
}  // namespace gw::test
