// What group and tricky do in their states: the wish behind each force, checked by hand; and that a shot
// warns those that it would hit, and no other.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kQuad = 1, kVertex = 3, kTexel = 4, kFragment = 5, kCompute = 6;

class think_group : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  const Rules::Steering& steering = rules.steering;
  const float ship_x = world.globals.ship.x, ship_y = world.globals.ship.y;

  think_group() { world.globals.tick = kLateTick; }

  std::vector<EntityRecord> run() {
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    return fixture.entities(true, false);
  }
  // The velocity that a force steers to, when the entity stood still.
  static Float2 wishOf(const EntityRecord& e, float response) {
    return {e.force_x / e.mass * kTick_s / response, e.force_y / e.mass * kTick_s / response};
  }
  EntityRecord& enemy(uint32_t id, uint32_t type, float x, float y, State state) {
    EntityRecord& e = world.add(enemyAt(rules, id, type, x, y));
    e.state = uint32_t(state);
    return e;
  }
};

TEST_F(think_group, a_group_draws_to_its_middle_and_turns_along_its_heading) {
  world.globals.ship.x = 180.0f;  // out of every enemy's sight
  const float x = 20.0f, y = 54.0f;
  EntityRecord& e = enemy(0, kVertex, x, y, State::grouping);
  e.direction_x = 0.0f;
  e.direction_y = 1.0f;
  for (uint32_t k = 1; k < 4; ++k) enemy(k, kVertex, x - 1.0f, y - 2.0f + float(k), State::grouping);  // heading +x
  enemy(9, kTexel, x + 2.0f, y, State::grouping);  // of another type: not company
  const EntityRecord after = run().at(0);
  ASSERT_EQ(after.state, uint32_t(State::grouping));
  const Float2 wish = wishOf(after, steering.response);
  const float speed = rules.enemies[kVertex].speed_mps * steering.wanderSpeed;
  EXPECT_NEAR(std::hypot(wish.x, wish.y), speed, 1e-3f);
  // Ahead (0, 1) but for the drift, the ship and their heading to +x, their middle to -x.
  const float way_x = steering.wanderToShip + steering.alignment - steering.cohesion;
  const float expected = std::atan2(1.0f, way_x), is = std::atan2(wish.y, wish.x);
  EXPECT_NEAR(is, expected, 0.13f);
  EXPECT_NEAR(after.direction_x, wish.x / speed, 1e-3f);  // it takes the way over
}

TEST_F(think_group, an_attacking_group_leans_along_its_heading) {
  enemy(0, kTexel, ship_x - 15.0f, ship_y, State::attacking);
  EntityRecord& other = enemy(1, kTexel, ship_x - 15.0f, ship_y + 3.0f, State::attacking);
  other.direction_x = 0.0f;
  other.direction_y = 1.0f;
  const Float2 wish = wishOf(run().at(0), steering.response);
  EXPECT_NEAR(wish.y / wish.x, steering.attackAlignment, 1e-4f);
  EXPECT_NEAR(std::hypot(wish.x, wish.y), rules.enemies[kTexel].speed_mps, 1e-3f);
}

// On three ticks of four its own heading stands for the others'.
TEST_F(think_group, an_attacking_group_asks_in_turns) {
  for (uint32_t tick = 0; tick < 4; ++tick) {
    SCOPED_TRACE(tick);
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick + tick;
    enemy(0, kTexel, ship_x - 15.0f, ship_y, State::attacking).direction_x = -1.0f;
    enemy(1, kTexel, ship_x - 15.0f, ship_y + 3.0f, State::attacking);  // heading +x
    const float along = tick % 4 == 0 ? 1.0f : -1.0f;
    const EntityRecord after = run().at(0);
    EXPECT_NEAR(after.direction_x, 1.0f, 1e-5f);
    world.entities[0].direction_x = 0.0f;
    world.entities[0].direction_y = 1.0f;
    const Float2 wish = wishOf(run().at(0), steering.response);
    EXPECT_NEAR(wish.y / wish.x, along > 0.0f ? 0.0f : steering.attackAlignment, 1e-4f);
  }
}

TEST_F(think_group, the_pace_makes_all_faster_but_a_dodge) {
  world.globals.pace = 1.5f;
  enemy(0, 0, ship_x - 15.0f, ship_y, State::attacking);
  enemy(1, kTexel, ship_x - 15.0f, ship_y + 10.0f, State::attacking);
  enemy(2, kCompute, ship_x - 15.0f, ship_y + 20.0f, State::attacking);
  enemy(3, kFragment, ship_x, ship_y + 30.0f, State::escaping).energy = 1.0f;
  enemy(4, 0, 1.0f + ship_x, 2.0f, State::wandering);  // 52 m from the ship: out of a triangle's sight
  enemy(5, kVertex, ship_x, ship_y - 15.0f, State::avoiding).timer = 5;
  const auto after = run();
  const auto speedOf = [&](uint32_t i, float response) {
    const Float2 wish = wishOf(after[i], response);
    return std::hypot(wish.x, wish.y);
  };
  EXPECT_NEAR(speedOf(0, steering.response), 1.5f * rules.enemies[0].speed_mps, 1e-3f);
  EXPECT_NEAR(speedOf(1, steering.response), 1.5f * rules.enemies[kTexel].speed_mps, 1e-3f);
  EXPECT_NEAR(speedOf(2, steering.response), 1.5f * rules.enemies[kCompute].speed_mps, 1e-3f);
  EXPECT_NEAR(speedOf(3, steering.response), 1.5f * rules.enemies[kFragment].speed_mps * steering.escapeSpeed, 1e-3f);
  EXPECT_NEAR(speedOf(4, steering.response), 1.5f * rules.enemies[0].speed_mps * steering.wanderSpeed, 1e-3f);
  EXPECT_NEAR(speedOf(5, steering.avoidResponse), steering.avoid_mps, 1e-3f);
}

TEST_F(think_group, the_tricky_come_aslant_from_afar_and_straight_when_near) {
  enemy(0, kCompute, ship_x - 20.0f, ship_y, State::attacking);
  enemy(1, kFragment, ship_x - 20.0f, ship_y + 30.0f, State::attacking);
  enemy(2, kCompute, ship_x + 9.0f, ship_y, State::attacking);
  const auto after = run();
  const Float2 even = wishOf(after[0], steering.response), near = wishOf(after[2], steering.response);
  EXPECT_NEAR(even.y / even.x, -steering.sideways, 1e-4f);  // even ids to the right of their way
  EXPECT_NEAR(near.x, -rules.enemies[kCompute].speed_mps, 1e-3f);
  EXPECT_NEAR(near.y, 0.0f, 1e-4f);
  const Float2 odd = wishOf(after[1], steering.response);
  const float toShip_x = 20.0f, toShip_y = -30.0f;
  EXPECT_GT(toShip_x * odd.y - toShip_y * odd.x, 0.0f);  // odd ids to the left
}

TEST_F(think_group, the_weak_tricky_flee_recover_and_return) {
  EntityRecord& e = enemy(0, kCompute, ship_x - 10.0f, ship_y, State::checkingEnergy);
  e.energy = 3.0f;  // of 8: under 40 %
  EntityRecord after = run().at(0);
  ASSERT_EQ(after.state, uint32_t(State::escaping));
  const Float2 wish = wishOf(after, steering.response);
  EXPECT_NEAR(wish.x, -rules.enemies[kCompute].speed_mps * steering.escapeSpeed, 1e-3f);
  EXPECT_NEAR(wish.y, 0.0f, 1e-4f);
  EXPECT_FLOAT_EQ(after.energy, 3.0f + 1.0f / 60.0f);
  uint32_t ticks = 1;
  while (after.state == uint32_t(State::escaping)) {
    world.entities.clear();
    after.force_x = after.force_y = 0.0f;
    world.add(after);
    after = run().at(0);
    ASSERT_LT(++ticks, 400u);
  }
  EXPECT_EQ(after.state, uint32_t(State::wandering));
  EXPECT_NEAR(after.energy, 0.9f * 8.0f, 0.02f);
  EXPECT_NEAR(float(ticks), 60.0f * 4.2f, 3.0f);  // from 3 to 7.2 at one a second
}

TEST_F(think_group, recovery_stops_at_full_energy) {
  SimulationConfig config = stageConfig();
  config.rules.steering.recoveredAt = 1.0f;
  config.rules.steering.recover_per_s = 1000.0f;
  StageFixture fast(config);
  world = fast.emptyWorld();
  world.globals.tick = kLateTick;
  enemy(0, kCompute, ship_x - 10.0f, ship_y, State::escaping).energy = 1.0f;
  fast.begin(world);
  cpu::think(fast.queue(), fast.view());
  EXPECT_EQ(fast.entities(true, false).at(0).energy, rules.enemies[kCompute].energy);
}

TEST_F(think_group, the_fleeing_keep_off_the_walls_and_come_out_of_corners) {
  struct Case {
    float x, y, way_x, way_y;
  };
  const float width = fixture.limits().width_m, height = fixture.limits().height_m;
  const Case cases[] = {{2.0f, ship_y + 8.0f, 0.0f, 1.0f},           // the left wall: along it, away
                        {width - 2.0f, ship_y - 8.0f, 0.0f, -1.0f},  // the right one
                        {ship_x + 8.0f, 2.0f, 1.0f, 0.0f},           // the lower one
                        {2.0f, 2.0f, 0.0f, 1.0f},                    // corners: along the wall that leads away sooner
                        {width - 2.0f, height - 2.0f, 0.0f, -1.0f}};
  uint32_t id = 0;
  for (const Case& c : cases) enemy(id++, kFragment, c.x, c.y, State::escaping).energy = 1.0f;
  const auto after = run();
  for (uint32_t i = 0; i < std::size(cases); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NEAR(after[i].direction_x, cases[i].way_x, 1e-4f);
    EXPECT_NEAR(after[i].direction_y, cases[i].way_y, 1e-4f);
  }
}

// With the ship straight off the wall, no side of it leads away sooner: then the wall's longer part, to the last metre.
TEST_F(think_group, the_fleeing_at_a_wall_right_before_the_ship_turn_to_its_longer_part) {
  const float width = fixture.limits().width_m, height = fixture.limits().height_m;
  for (const float part : {0.497f, 0.503f}) {
    SCOPED_TRACE(part);
    const float longer = part < 0.5f ? 1.0f : -1.0f;
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    world.globals.ship.x = part * width;
    world.globals.ship.y = 9.0f;
    enemy(0, kFragment, part * width, 2.0f, State::escaping).energy = 1.0f;
    const EntityRecord below = run().at(0);
    EXPECT_EQ(below.direction_x, longer);
    EXPECT_EQ(below.direction_y, 0.0f);
    world.entities.clear();
    world.globals.ship.x = 9.0f;
    world.globals.ship.y = part * height;
    enemy(0, kFragment, 2.0f, part * height, State::escaping).energy = 1.0f;
    const EntityRecord beside = run().at(0);
    EXPECT_EQ(beside.direction_x, 0.0f);
    EXPECT_EQ(beside.direction_y, longer);
  }
}

// A dodge goes across the shot's path, to the side where it already is, for twelve ticks at 15 m/s.
TEST_F(think_group, a_dodge_leaves_the_path_by_the_nearer_side) {
  for (const float side : {0.2f, -0.2f}) {
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    enemy(0, kTexel, 60.0f, 30.0f + side, State::wandering);
    world.add(shotAt(rules, 1, 55.0f, 30.0f, 0.0f));
    EntityRecord after = run().at(0);
    ASSERT_EQ(after.state, uint32_t(State::avoiding));
    EXPECT_EQ(after.timer, steering.avoid_ticks);
    EXPECT_EQ(after.cooldown, rules.enemies[kTexel].avoidCooldown_ticks);
    const Float2 wish = wishOf(after, steering.avoidResponse);
    EXPECT_NEAR(wish.y, side > 0.0f ? steering.avoid_mps : -steering.avoid_mps, 1e-3f);
    EXPECT_NEAR(wish.x, 0.0f, 1e-4f);
    uint32_t ticks = 0;
    while (after.state == uint32_t(State::avoiding)) {
      world.entities.clear();
      world.add(after);
      after = run().at(0);
      ++ticks;
      ASSERT_LE(ticks, 20u);
    }
    EXPECT_EQ(ticks, steering.avoid_ticks);
  }
}

// A shot that comes exactly through its middle has no nearer side: odd ids step to the left of its path, even ones to
// the right.
TEST_F(think_group, in_the_very_middle_of_a_path_the_id_chooses_the_side) {
  for (const float heading : {1.0f, -1.0f}) {
    SCOPED_TRACE(heading);
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    for (uint32_t id = 0; id < 4; ++id) {
      const float y = 20.0f + 10.0f * float(id);
      enemy(id, kTexel, 60.0f, y, State::wandering);
      EntityRecord& shot = world.add(shotAt(rules, 10 + id, 60.0f - 5.0f * heading, y, 0.0f));
      shot.direction_x = heading;
      shot.direction_y = 0.0f;
    }
    const auto after = run();
    for (uint32_t id = 0; id < 4; ++id) {
      ASSERT_EQ(after[id].state, uint32_t(State::avoiding)) << id;
      EXPECT_EQ(after[id].direction_x, 0.0f) << id;
      EXPECT_EQ(after[id].direction_y, id % 2 == 1 ? heading : -heading) << id;
    }
  }
}

TEST_F(think_group, only_shots_ahead_near_and_on_course_warn) {
  struct Case {
    float dx, dy, angle;  // the shot, from the enemy
    bool warns;
  };
  const float edge = rules.enemies[kVertex].halfWidth_m + steering.threatMargin_m;
  const Case cases[] = {{-5.9f, 0.0f, 0.0f, true},         {-6.1f, 0.0f, 0.0f, false},
                        {5.0f, 0.0f, 0.0f, false},         {5.0f, 0.0f, 3.14159f, true},
                        {-4.0f, edge - 0.01f, 0.0f, true}, {-4.0f, edge + 0.01f, 0.0f, false}};
  for (const Case& c : cases) {
    world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    enemy(0, kVertex, 60.0f, 30.0f, State::wandering);
    world.add(shotAt(rules, 1, 60.0f + c.dx, 30.0f + c.dy, c.angle));
    EXPECT_EQ(run().at(0).state == uint32_t(State::avoiding), c.warns) << c.dx << ", " << c.dy;
  }
}

TEST_F(think_group, kamikazes_and_the_announced_do_not_dodge) {
  enemy(0, kQuad, 60.0f, 30.0f, State::wandering);
  enemy(1, kVertex, 60.0f, 40.0f, State::wandering).birthTick = kLateTick - 5;
  world.add(shotAt(rules, 2, 57.0f, 30.0f, 0.0f));
  world.add(shotAt(rules, 3, 57.0f, 40.0f, 0.0f));
  for (const EntityRecord& e : run()) {
    if (e.type >= kMaxEnemyTypes) continue;
    EXPECT_EQ(e.state, uint32_t(State::wandering)) << e.type;
  }
}

}  // namespace
}  // namespace gw::test
