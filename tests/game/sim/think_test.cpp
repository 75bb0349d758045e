#include <gtest/gtest.h>

#include <cmath>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class think : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();

  think() { world.globals.tick = kLateTick; }

  // Every entity after one think.
  std::vector<EntityRecord> run() {
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    return fixture.entities(true, false);
  }
};

TEST_F(think, is_the_naive_version_on_crowds) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick + seed;
    world.globals.seed = seed;
    Dice dice(seed);
    addCrowd(world, 150, 20, 60, 50.0f, dice);
    const auto is = run();
    naive::think(world);
    EXPECT_TRUE(same(is, world.records()));
  }
}

// F = m a: one tick of the force closes `response` of the gap to the wished velocity.
TEST_F(think, an_attacker_closes_the_gap_to_full_speed_at_the_ship) {
  EntityRecord e = enemyAt(rules, 0, 1, world.globals.ship.x, world.globals.ship.y + 10.0f);
  e.state = uint32_t(State::attacking);
  e.velocity_x = 2.0f;
  world.add(e);
  const EntityRecord after = run().at(0);
  EXPECT_NEAR(after.force_x / e.mass * kTick_s, 0.08f * (0.0f - 2.0f), 1e-5f);
  EXPECT_NEAR(after.force_y / e.mass * kTick_s, 0.08f * -rules.enemies[1].speed_mps, 1e-5f);
  EXPECT_EQ(after.direction_x, 0.0f);
  EXPECT_EQ(after.direction_y, -1.0f);
}

TEST_F(think, a_damaged_attacker_is_a_quarter_faster) {
  EntityRecord e = enemyAt(rules, 0, 1, world.globals.ship.x - 10.0f, world.globals.ship.y);
  e.state = uint32_t(State::attacking);
  e.energy -= 1.0f;
  world.add(e);
  EXPECT_NEAR(run().at(0).force_x / e.mass * kTick_s, 0.08f * 1.25f * rules.enemies[1].speed_mps, 1e-5f);
}

TEST_F(think, a_wanderer_drifts_at_most_so_far_a_tick_at_its_share_of_the_speed) {
  const uint32_t hexagon = 2;
  float most = 0.0f;
  for (uint32_t i = 0; i < 200; ++i) {
    EntityRecord e = enemyAt(rules, i, hexagon, 2.0f + 0.05f * float(i), 3.0f);  // the ship is past 60 m
    e.direction_x = 0.0f;
    e.direction_y = 1.0f;
    world.add(e);
  }
  for (const EntityRecord& e : run()) {
    EXPECT_EQ(e.state, uint32_t(State::wandering));
    const float wish = std::hypot(e.force_x, e.force_y) / e.mass * kTick_s / 0.08f;
    EXPECT_NEAR(wish, 0.6f * rules.enemies[hexagon].speed_mps, 1e-4f);
    const float drift = std::fabs(std::atan2(-e.direction_x, e.direction_y));
    EXPECT_LE(drift, 0.12f + 1e-6f);
    most = std::max(most, drift);
  }
  EXPECT_GT(most, 0.1f);  // and uses that range
}

TEST_F(think, an_announced_enemy_only_stands_there) {
  EntityRecord e = enemyAt(rules, 0, 0, world.globals.ship.x + 3.0f, world.globals.ship.y);
  e.birthTick = kLateTick - 29;
  e.flags = kFlagHit;
  world.add(e);
  EXPECT_TRUE(same(run(), {e}));
  world.globals.tick = kLateTick + 1;  // and no longer
  EXPECT_EQ(run().at(0).state, uint32_t(State::checkingEnergy));
}

TEST_F(think, bits_come_from_five_metres_and_are_taken_at_one) {
  const float x = world.globals.ship.x, y = world.globals.ship.y;
  const float distances[] = {0.0f, 1.0f, 1.001f, 5.0f, 5.001f};
  for (uint32_t i = 0; i < 5; ++i) world.add(bitAt(rules, i, x - distances[i], y));
  const auto after = run();
  const auto events = fixture.events();
  for (uint32_t i = 0; i < 5; ++i) {
    SCOPED_TRACE(distances[i]);
    EXPECT_EQ(events[i], i < 2 ? uint32_t(kEventTaken) : 0u);
    EXPECT_FLOAT_EQ(after[i].velocity_x, i < 2 ? 3.0f : i < 4 ? 22.0f : 3.0f * 0.94f);
  }
}

TEST_F(think, nobody_thinks_once_the_game_is_over) {
  world.globals.over = 1;
  Dice dice(3);
  addCrowd(world, 50, 5, 20, 10.0f, dice);
  EXPECT_TRUE(same(run(), world.records()));
}

}  // namespace
}  // namespace gw::test
