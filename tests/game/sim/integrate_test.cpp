#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/game/sim/random_values.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class integrate : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();

  integrate() { world.globals.tick = kLateTick; }

  std::vector<EntityRecord> run() {
    fixture.begin(world);
    cpu::integrate(fixture.queue(), fixture.view());
    return fixture.entities(true, true);
  }

  // The only enemy, after one step from rest there with that velocity.
  EntityRecord step(uint32_t type, float x, float y, float velocity_x, float velocity_y) {
    EntityRecord e = enemyAt(rules, 0, type, x, y);
    e.velocity_x = velocity_x;
    e.velocity_y = velocity_y;
    e.direction_x = velocity_x < 0.0f ? -1.0f : 1.0f;
    world.entities.clear();
    world.add(e);
    return run().at(0);
  }
};

TEST_F(integrate, is_the_naive_version_on_crowds) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    world.globals.ship.x = seed % 2 ? 5.0f : 96.0f;  // some crowds are at the walls
    Dice dice(seed);
    addCrowd(world, 150, 60, 60, 40.0f, dice);
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    cpu::integrate(fixture.queue(), fixture.view());
    naive::think(world);
    naive::integrate(world);
    std::erase_if(world.entities, [](const naive::Entity& e) { return e.gone; });
    EXPECT_TRUE(same(fixture.entities(true, true), world.records()));
  }
}

TEST_F(integrate, velocity_comes_from_force_and_mass_and_place_from_velocity) {
  EntityRecord e = enemyAt(rules, 0, 1, 50.0f, 50.0f);
  e.velocity_x = 3.0f;
  e.force_x = 60.0f * 2.0f;  // mass 2: one m/s a tick
  e.push_y = 6.0f;           // moves it, but is not its own velocity
  world.add(e);
  const EntityRecord after = run().at(0);
  EXPECT_FLOAT_EQ(after.velocity_x, 4.0f);
  EXPECT_EQ(after.velocity_y, 0.0f);
  EXPECT_FLOAT_EQ(after.x, 50.0f + 4.0f / 60.0f);
  EXPECT_FLOAT_EQ(after.y, 50.1f);
  EXPECT_EQ(after.previous_x, 50.0f);
  EXPECT_EQ(after.previous_y, 50.0f);
}

TEST_F(integrate, nobody_moves_faster_than_the_limit_but_keeps_the_velocity) {
  const float limit_m = fixture.limits().fastestEnemy_mps * kTick_s;
  EXPECT_FLOAT_EQ(step(1, 50.0f, 50.0f, 25.0f, 0.0f).x, 50.0f + limit_m);
  EXPECT_FLOAT_EQ(step(1, 50.0f, 50.0f, 23.0f, 0.0f).x, 50.0f + 23.0f / 60.0f);
  EXPECT_EQ(step(1, 50.0f, 50.0f, 25.0f, 0.0f).velocity_x, 25.0f);
}

TEST_F(integrate, walls_turn_velocity_and_heading_round) {
  const float width = fixture.limits().width_m, height = fixture.limits().height_m;
  const EntityRecord left = step(2, 1.21f, 50.0f, -6.0f, 1.0f);
  EXPECT_EQ(left.x, 1.2f);
  EXPECT_EQ(left.velocity_x, 6.0f);
  EXPECT_EQ(left.direction_x, 1.0f);
  EXPECT_EQ(left.velocity_y, 1.0f);
  const EntityRecord right = step(2, width - 1.21f, 50.0f, 6.0f, 0.0f);
  EXPECT_EQ(right.x, width - 1.2f);
  EXPECT_EQ(right.velocity_x, -6.0f);
  EXPECT_EQ(right.direction_x, -1.0f);
  EXPECT_EQ(step(2, 50.0f, 1.21f, 0.0f, -6.0f).velocity_y, 6.0f);
  EXPECT_EQ(step(2, 50.0f, height - 1.21f, 0.0f, 6.0f).velocity_y, -6.0f);
}

RC_GTEST_FIXTURE_PROP(integrate, enemies_stay_inside_and_under_the_speed_limit, ()) {
  const uint32_t type = below(rules.enemyTypeCount);
  const EnemyRules& body = rules.enemies[type];
  const float width = fixture.limits().width_m, height = fixture.limits().height_m;
  EntityRecord e = enemyAt(rules, 0, type, 0.0f, 0.0f);
  e.x = std::clamp(number(0, 192), body.halfWidth_m, width - body.halfWidth_m);
  e.y = std::clamp(number(0, 108), body.halfHeight_m, height - body.halfHeight_m);
  const float fastest = below(2) ? 40.0f : 500.0f;  // half of them not far from the limit
  e.velocity_x = number(-fastest, fastest);
  e.velocity_y = number(-fastest, fastest);
  e.push_x = number(-6, 6);
  e.force_y = number(-900, 900);
  world.add(e);
  const EntityRecord after = run().at(0);
  RC_ASSERT(after.x >= body.halfWidth_m);
  RC_ASSERT(after.x <= width - body.halfWidth_m);
  RC_ASSERT(after.y >= body.halfHeight_m);
  RC_ASSERT(after.y <= height - body.halfHeight_m);
  const float step_m = std::hypot(after.x - e.x, after.y - e.y);
  RC_ASSERT(step_m <= fixture.limits().fastestEnemy_mps * kTick_s * 1.0001f);
  RC_ASSERT(after.previous_x == e.x);
  RC_ASSERT(after.previous_y == e.y);
}

TEST_F(integrate, the_dead_stay_where_they_died) {
  EntityRecord e = enemyAt(rules, 0, 0, 40.0f, 41.0f);
  e.state = uint32_t(State::dead);
  e.velocity_x = 9.0f;
  e.push_y = 5.0f;
  world.add(e);
  const EntityRecord after = run().at(0);
  EXPECT_EQ(after.x, 40.0f);
  EXPECT_EQ(after.y, 41.0f);
  EXPECT_EQ(after.velocity_x, 0.0f);
}

TEST_F(integrate, a_shot_counts_down_its_life_and_ends_with_it) {
  world.add(shotAt(rules, 0, 60.0f, 50.0f, 0.0f));
  world.add(shotAt(rules, 1, 60.0f, 60.0f, 0.0f));
  world.entities[0].timer = 2;
  world.entities[1].timer = 1;
  const auto after = run();
  ASSERT_EQ(after.size(), 1u);
  EXPECT_EQ(after[0].id, 0u);
  EXPECT_EQ(after[0].timer, 1u);
  EXPECT_FLOAT_EQ(after[0].x, 60.75f);
  EXPECT_EQ(after[0].previous_x, 60.0f);
}

TEST_F(integrate, shots_end_at_the_walls_where_bits_stop) {
  const float width = fixture.limits().width_m;
  world.add(shotAt(rules, 0, width - 0.5f, 50.0f, 0.0f));
  world.add(bitAt(rules, 1, width - 0.01f, 50.0f));
  const auto after = run();
  ASSERT_EQ(after.size(), 1u);
  EXPECT_EQ(after[0].id, 1u);
  EXPECT_EQ(after[0].x, width);
}

TEST_F(integrate, nothing_moves_once_the_game_is_over) {
  world.globals.over = 1;
  Dice dice(4);
  addCrowd(world, 60, 20, 20, 20.0f, dice);
  EXPECT_TRUE(same(run(), world.records()));
}

}  // namespace
}  // namespace gw::test
