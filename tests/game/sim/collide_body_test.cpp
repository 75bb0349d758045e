// Contact response: how overlapping bodies push each other apart.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "game/sim/contact/overlap.h"
#include "tests/game/sim/random_values.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

RC_GTEST_PROP(overlap, is_odd_to_the_last_bit, ()) {
  const EnemyRules a = someBody(), b = someBody();
  const float reach = a.halfWidth_m + b.halfWidth_m + a.halfHeight_m + b.halfHeight_m;
  const bool coincident = below(8) == 0;
  const float dx = coincident ? 0.0f : number(-reach, reach), dy = coincident ? 0.0f : number(-reach, reach);
  const Float2 of_a = cpu::overlap(a, b, dx, dy, 1.0f), of_b = cpu::overlap(b, a, -dx, -dy, -1.0f);
  RC_ASSERT(of_a.x == -of_b.x);
  RC_ASSERT(of_a.y == -of_b.y);
}

// The vector is the way out: after it the bodies are free, and before nine tenths of it they are not.
RC_GTEST_PROP(overlap, takes_bodies_just_apart, ()) {
  const EnemyRules a = someBody(), b = someBody();
  const float dx = number(-3.0f, 3.0f), dy = number(-3.0f, 3.0f);
  const Float2 out = cpu::overlap(a, b, dx, dy, 1.0f);
  const float depth = cpu::length(out.x, out.y);
  RC_PRE(depth > 0.01f);
  const auto still = [&](float share) {
    const Float2 rest = cpu::overlap(a, b, dx + share * out.x, dy + share * out.y, 1.0f);
    return cpu::length(rest.x, rest.y);
  };
  RC_ASSERT(still(1.0f) < 1.0e-3f);
  RC_ASSERT(still(0.9f) > 0.05f * depth);
}

class separation : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();

  separation() { world.globals.tick = kLateTick; }

  std::vector<EntityRecord> run() {
    fixture.begin(world);
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    return fixture.entities(true, true);
  }
};

TEST_F(separation, a_pair_of_one_mass_is_pushed_evenly_to_the_last_bit) {
  world.add(enemyAt(rules, 3, 0, 40.03f, 40.0f));
  world.add(enemyAt(rules, 8, 0, 40.96f, 40.13f));
  const auto after = run();
  EXPECT_LT(after[0].push_x, 0.0f);
  EXPECT_EQ(after[0].push_x, -after[1].push_x);
  EXPECT_EQ(after[0].push_y, -after[1].push_y);
  // Half of the depth in one tick, shared by two.
  const float depth = 1.0f - std::hypot(0.93f, 0.13f);
  EXPECT_NEAR(std::hypot(after[0].push_x, after[0].push_y), depth / 4.0f * 60.0f, 1.0e-3f);
}

TEST_F(separation, the_light_one_yields_by_the_masses) {
  world.add(enemyAt(rules, 0, 2, 40.0f, 40.0f));   // 8
  world.add(enemyAt(rules, 1, 0, 41.65f, 40.0f));  // 1
  const auto after = run();
  EXPECT_NEAR(after[0].push_x * 8.0f, -after[1].push_x, 1.0e-3f);
  EXPECT_GT(after[1].push_x, 0.0f);
}

TEST_F(separation, coincident_bodies_part_by_their_ids) {
  for (const uint32_t type : {0u, 1u}) {
    world.entities.clear();
    world.add(enemyAt(rules, 2, type, 40.0f, 40.0f));
    world.add(enemyAt(rules, 9, type, 40.0f, 40.0f));
    const auto after = run();
    EXPECT_EQ(after[0].push_x, -after[1].push_x);
    EXPECT_EQ(after[0].push_y, -after[1].push_y);
    EXPECT_GT(after[0].push_x + after[0].push_y, 1.0f);
  }
}

TEST_F(separation, is_never_faster_than_the_rules_say) {
  Dice dice(11);
  for (uint32_t i = 0; i < 120; ++i) {
    world.add(enemyAt(rules, i, i % 3, 40.0f + dice.between(0.0f, 2.0f), 40.0f + dice.between(0.0f, 2.0f)));
  }
  float fastest = 0.0f;
  for (const EntityRecord& e : run()) fastest = std::max(fastest, std::hypot(e.push_x, e.push_y));
  EXPECT_LE(fastest, 6.0f * 1.000001f);
  EXPECT_GT(fastest, 5.99f);
}

// Three in a row: the middle one's pushes cancel, 6 m/s of them, so it keeps 4 / (4 + 6) of its velocity; the outer
// ones are pushed from one side only, and not held across it.
TEST_F(separation, holds_what_is_pressed_from_both_sides) {
  ASSERT_EQ(rules.steering.press_mps, 4.0f);
  for (const uint32_t id : {0u, 1u, 2u}) {
    world.add(enemyAt(rules, id, 0, 40.0f + 0.8f * float(id), 40.0f)).velocity_y = 2.0f;
  }
  const auto after = run();
  EXPECT_NEAR(after[1].push_x, 0.0f, 1.0e-4f);
  EXPECT_NEAR(after[1].velocity_y, 2.0f * 4.0f / (4.0f + 6.0f), 1.0e-3f);
  EXPECT_EQ(after[0].velocity_y, 2.0f);
  EXPECT_EQ(after[2].velocity_y, 2.0f);
}

TEST_F(separation, frees_a_heap_in_a_few_seconds) {
  Dice dice(12);
  for (uint32_t i = 0; i < 60; ++i) {
    world.add(enemyAt(rules, i, i % 3, 40.0f + dice.between(0.0f, 3.0f), 40.0f + dice.between(0.0f, 3.0f)));
  }
  for (int tick = 0; tick < 240; ++tick) {
    auto after = run();
    world.entities.clear();
    for (const EntityRecord& e : after) world.add(e);
  }
  float deepest = 0.0f;
  for (const EntityRecord& a : world.entities) {
    for (const EntityRecord& b : world.entities) {
      if (a.id >= b.id) continue;
      const Float2 out = cpu::overlap(rules.enemies[a.type], rules.enemies[b.type], a.x - b.x, a.y - b.y, 1.0f);
      deepest = std::max(deepest, std::hypot(out.x, out.y));
    }
  }
  EXPECT_LT(deepest, 0.05f);
}

TEST_F(separation, the_dead_push_nobody) {
  world.add(enemyAt(rules, 0, 0, 40.0f, 40.0f));
  world.add(enemyAt(rules, 1, 0, 40.5f, 40.0f)).state = uint32_t(State::dead);
  EXPECT_EQ(run()[0].push_x, 0.0f);
}

}  // namespace
}  // namespace gw::test
