#include <gtest/gtest.h>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class settle : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  const float x = world.globals.ship.x, y = world.globals.ship.y;

  settle() { world.globals.tick = kLateTick; }

  EntityRecord& enemy(uint32_t id, uint32_t type, float at_x, float at_y) {
    return world.add(enemyAt(rules, id, type, at_x, at_y));
  }
  Totals run() {
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::settle(fixture.queue(), fixture.view());
    return fixture.globals().totals;
  }
};

TEST_F(settle, is_the_naive_version_on_crowds) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    Dice dice(seed);
    addCrowd(world, 200, 60, 120, seed % 2 ? 60.0f : 8.0f, dice);
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    cpu::settle(fixture.queue(), fixture.view());
    naive::think(world);
    naive::integrate(world);
    naive::collide(world);
    naive::settle(world);
    EXPECT_TRUE(same(fixture.globals(), world.globals));
  }
}

TEST_F(settle, counts_cells_by_type) {
  enemy(0, 0, 20.0f, 20.0f);
  enemy(1, 2, 30.0f, 20.0f);
  enemy(2, 2, 40.0f, 20.0f).state = uint32_t(State::dead);
  world.add(shotAt(rules, 3, 50.0f, 50.0f, 0.0f));
  world.add(shotAt(rules, 4, 60.0f, 50.0f, 0.0f)).timer = 1;  // leaves in this tick
  world.add(bitAt(rules, 5, x + 20.0f, y));
  const Totals t = run();
  EXPECT_EQ(t.occupied[0], 1u);
  EXPECT_EQ(t.occupied[2], 2u);
  EXPECT_EQ(t.dying, 1u);
  EXPECT_EQ(t.occupied[kTypeShot], 1u);
  EXPECT_EQ(t.occupied[kTypeBit], 1u);
}

TEST_F(settle, deaths_score_by_how_they_came_and_sound_by_where) {
  const auto die = [&](uint32_t id, float at_x, uint32_t flags) {
    EntityRecord& e = enemy(id, 1, at_x, y);
    e.state = uint32_t(State::checkingEnergy);
    e.energy = 0.0f;
    e.flags = flags;
  };
  die(0, x - 7.0f, 0);
  die(1, x - 5.0f, kFlagFlushed);
  die(2, x + 5.0f, kFlagFlushed);
  die(3, x + 7.0f, kFlagBlasted);
  enemy(4, 1, x, y + 9.0f).state = uint32_t(State::dead);  // died a tick ago: is not counted again
  const Totals t = run();
  EXPECT_EQ(t.kills[1], 1u);
  EXPECT_EQ(t.bareKills[1], 2u);
  const Tally tally = fixture.scratch().tally;
  EXPECT_EQ(tally.killSounds[1][0], 1u);
  EXPECT_EQ(tally.killSounds[1][1], 2u);
  EXPECT_EQ(tally.killSounds[1][2], 1u);
  EXPECT_EQ(t.dying, 5u);
  EXPECT_EQ(tally.edges.taken[0][uint32_t(State::checkingEnergy)][uint32_t(State::dead)], 4u);
}

TEST_F(settle, tells_who_is_in_view_and_who_is_coming) {
  enemy(0, 0, x + 35.9f, y + 19.9f);                    // in view, too far to see the ship
  enemy(1, 0, x + 36.1f, y);                            // out of view
  enemy(2, 0, x, y - 20.1f).birthTick = kLateTick - 3;  // announced
  enemy(3, 2, x + 50.0f, y);                            // a hexagon sees 60 m: attacks
  for (naive::Entity& e : world.entities) e.direction_y = 1.0f, e.direction_x = 0.0f;
  const Totals t = run();
  EXPECT_EQ(t.inView, 1u);
  EXPECT_EQ(t.coming, 2u);
}

TEST_F(settle, counts_bits_that_were_taken_or_ran_out) {
  world.add(bitAt(rules, 0, x + 0.9f, y));
  world.add(bitAt(rules, 1, x - 0.9f, y));
  world.add(bitAt(rules, 2, x + 30.0f, y)).timer = 1;
  const Totals t = run();
  EXPECT_EQ(t.bitsTaken, 2u);
  EXPECT_EQ(t.occupied[kTypeBit], 0u);
}

TEST_F(settle, adds_nothing_once_the_game_is_over) {
  world.globals.over = 1;
  world.globals.totals.kills[0] = 3;
  Dice dice(2);
  addCrowd(world, 80, 5, 20, 20.0f, dice);
  run();
  EXPECT_TRUE(same(fixture.globals(), world.globals));
}

}  // namespace
}  // namespace gw::test
