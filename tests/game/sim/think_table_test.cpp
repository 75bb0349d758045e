// The kamikaze's table, edge by edge, against RULES.md read a second time (tests/naive/sim_think.cpp).
#include <gtest/gtest.h>

#include "game/sim/behaviour.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kStates = uint32_t(State::count), kSets = 1u << kConditionCount;

TEST(think_table, all_states_and_all_sets_of_conditions) {
  for (uint32_t state = 0; state < kStates; ++state) {
    for (uint32_t set = 0; set < kSets; ++set) {
      const naive::Kamikaze wanted = naive::kamikazeStep(naive::Kamikaze(state), set & kDamaged, set & kEnergyGone,
                                                         set & kSeesShip, set & kLostShip);
      EXPECT_EQ(uint32_t(cpu::nextState(kKamikaze, State(state), set)), uint32_t(wanted))
          << nameOf(State(state)) << " with conditions " << set;
    }
  }
}

// A row that an earlier one always hides would be dead data.
TEST(think_table, every_row_is_the_first_to_apply_somewhere) {
  for (uint32_t row = 0; row < kKamikaze.count; ++row) {
    bool reached = false;
    for (uint32_t state = 0; state < kStates; ++state) {
      for (uint32_t set = 0; set < kSets; ++set) {
        const auto applies = [&](const Transition& t) { return (t.from >> state & 1u) && (t.needs & set) == t.needs; };
        bool earlier = false;
        for (uint32_t i = 0; i < row; ++i) earlier = earlier || applies(kKamikaze.rows[i]);
        reached = reached || (!earlier && applies(kKamikaze.rows[row]));
      }
    }
    EXPECT_TRUE(reached) << "row " << row;
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

TEST(think_table, the_kernel_finds_every_condition_that_can_hold) {
  StageFixture fixture;
  const Rules& rules = fixture.rules();
  const uint32_t quad = 1;
  ASSERT_EQ(rules.enemies[quad].sight_m, 24.0f);  // its multiples below are exact
  for (uint32_t state = 0; state < kStates; ++state) {
    for (const Place& place : kPlaces) {
      for (uint32_t health = 0; health < 4; ++health) {
        const bool hit = health & 1, gone = health & 2;
        naive::World world = fixture.emptyWorld();
        world.master.tick = kLateTick;
        EntityRecord e = enemyAt(rules, 5, quad, world.master.ship.x + place.sights * 24.0f, world.master.ship.y);
        e.state = state;
        e.flags = hit ? uint32_t(kFlagHit) : 0u;
        if (gone) e.energy = 0.0f;
        world.add(e);
        fixture.begin(world);
        cpu::think(fixture.queue(), fixture.view());

        const EntityRecord after = fixture.entities(true, false).at(0);
        const uint32_t event = fixture.events().at(5);
        const State wanted = State(naive::kamikazeStep(naive::Kamikaze(state), hit, gone, place.sees, place.lost));
        SCOPED_TRACE(std::string(nameOf(State(state))) + ", " + place.name + (hit ? ", hit" : "") +
                     (gone ? ", energy gone" : ""));
        EXPECT_EQ(after.state, uint32_t(wanted));
        EXPECT_EQ(event & kEventTransition, wanted != State(state) ? kEventTransition : 0u);
        EXPECT_EQ(event & kEventDied, wanted == State::dead && state != uint32_t(State::dead) ? kEventDied : 0u);
        // Only the check takes notice of a hit, so that no hit is ever lost.
        EXPECT_EQ(after.flags & kFlagHit, hit && wanted != State::checkingEnergy ? kFlagHit : 0u);
      }
    }
  }
}

TEST(think_table, two_hits_in_a_row_are_checked_twice) {
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  world.master.tick = kLateTick;
  EntityRecord e = enemyAt(fixture.rules(), 0, 1, world.master.ship.x + 10.0f, world.master.ship.y);
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
