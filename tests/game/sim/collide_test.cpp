// Collide: hits and their victims, what they cost, and what the ship's contact, blast and flush do.
#include <gtest/gtest.h>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kTriangle = 0, kQuad = 1, kHexagon = 2;

class collide : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  const float x = world.globals.ship.x, y = world.globals.ship.y + 30.0f;  // a place far from the ship

  collide() { world.globals.tick = kLateTick; }

  EntityRecord& enemy(uint32_t id, uint32_t type, float at_x, float at_y) {
    return world.add(enemyAt(rules, id, type, at_x, at_y));
  }
  EntityRecord& shot(uint32_t id, float at_x, float at_y, uint32_t hits = 1) {
    return world.add(shotAt(rules, id, at_x, at_y, 0.0f, hits));
  }

  // One tick without thoughts; what is left becomes the world. The globals's totals are kept apart.
  void run() {
    fixture.begin(world);
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    contact = fixture.globals().totals.contact;
    world.entities.clear();
    for (const EntityRecord& e : fixture.entities(true, true)) world.add(e);
  }
  bool has(uint32_t id) const {
    for (const EntityRecord& e : world.entities) {
      if (e.id == id) return true;
    }
    return false;
  }

  uint64_t contact = 0;
};

TEST_F(collide, is_the_naive_version_on_crowds) {
  for (uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    GameGlobals& m = world.globals;
    m.tick = kLateTick;
    if (seed % 3 == 1) m.ship.x = m.ship.previous_x = 4.0f;
    Dice dice(seed);
    addCrowd(world, 150, 120, 10, seed % 2 ? 8.0f : 20.0f, dice);
    if (seed % 4 == 1) m.ship.untouchable_ticks = 3;
    if (seed % 4 == 2) m.flushRadius_m = 9.0f;
    m.flush_x = m.ship.x + 3.0f;
    m.flush_y = m.ship.y;
    m.blast = seed % 4 == 3;
    m.blastId = m.blast ? world.entities[dice.below(100)].id : kNobody;
    fixture.begin(world);
    cpu::think(fixture.queue(), fixture.view());
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    naive::think(world);
    naive::integrate(world);
    naive::collide(world);
    std::erase_if(world.entities, [](const naive::Entity& e) { return e.gone; });
    EXPECT_TRUE(same(fixture.entities(true, true), world.records()));
    EXPECT_TRUE(same(fixture.globals(), m));
  }
}

TEST_F(collide, a_shot_takes_the_first_on_its_way_and_the_lowest_id_of_a_tie) {
  enemy(9, kTriangle, x + 1.0f, y);
  enemy(4, kTriangle, x + 1.4f, y);
  shot(20, x, y);
  enemy(8, kTriangle, x + 1.0f, y + 10.0f);  // two on one place
  enemy(3, kTriangle, x + 1.0f, y + 10.0f);
  shot(21, x, y + 10.0f);
  run();
  EXPECT_EQ(world.byId(9).energy, 0.0f);
  EXPECT_EQ(world.byId(4).energy, 1.0f);
  EXPECT_EQ(world.byId(3).energy, 0.0f);
  EXPECT_EQ(world.byId(8).energy, 1.0f);
  EXPECT_FALSE(has(20));
  EXPECT_FALSE(has(21));
}

// Energy lost = hits spent: of five shots at an enemy of 3, two fly on and hit the one behind.
TEST_F(collide, shots_that_are_not_needed_fly_on) {
  enemy(0, kQuad, x + 1.0f, y);
  enemy(1, kHexagon, x + 4.0f, y);
  for (uint32_t i = 0; i < 5; ++i) shot(10 + i, x - 0.02f * float(i), y);
  run();
  EXPECT_EQ(world.byId(0).energy, 0.0f);
  EXPECT_FALSE(has(10));
  EXPECT_FALSE(has(11));
  EXPECT_FALSE(has(12));
  ASSERT_TRUE(has(13));
  ASSERT_TRUE(has(14));
  EXPECT_NEAR(world.byId(13).x, x + 1.0f - 0.55f - 0.2f, 1.0e-4f);  // they wait at the skin for one tick
  for (int tick = 0; tick < 4; ++tick) run();
  EXPECT_EQ(world.byId(1).energy, 14.0f);
  EXPECT_FALSE(has(13));
  EXPECT_FALSE(has(14));
}

TEST_F(collide, shots_count_in_order_of_time_then_id) {
  enemy(0, kTriangle, x + 1.0f, y);
  shot(30, x + 0.1f, y);  // the nearest wins though its id is the highest
  shot(20, x, y);
  shot(21, x, y);
  run();
  EXPECT_FALSE(has(30));
  EXPECT_TRUE(has(20));
  EXPECT_TRUE(has(21));
  enemy(1, kTriangle, x + 1.0f, y + 9.0f);
  shot(41, x, y + 9.0f);
  shot(40, x, y + 9.0f);  // a tie
  run();
  EXPECT_FALSE(has(40));
  EXPECT_TRUE(has(41));
}

TEST_F(collide, a_row_is_hit_one_by_one_for_as_many_hits_as_a_shot_has) {
  for (uint32_t i = 0; i < 5; ++i) enemy(i, i % 2 ? kQuad : kTriangle, x + 1.0f + 0.6f * float(i), y);
  shot(10, x, y, 3);
  uint32_t hitsBefore = 0;
  for (int tick = 0; tick < 12 && has(10); ++tick) {
    for (auto& e : world.entities) {  // hold the row still
      if (e.type != kTypeShot) e.velocity_x = e.push_x = e.push_y = 0.0f;
    }
    run();
    const uint32_t hits = has(10) ? 3 - world.byId(10).cooldown : 3;
    EXPECT_LE(hits, hitsBefore + 1);
    hitsBefore = hits;
    for (uint32_t i = 0; i < 5; ++i) {
      EXPECT_EQ(world.byId(i).energy, rules.enemies[i % 2].energy - (i < hits ? 1.0f : 0.0f)) << i;
    }
  }
  EXPECT_EQ(hitsBefore, 3u);
}

TEST_F(collide, a_shot_that_leaves_the_world_hits_who_stands_at_the_wall) {
  const float height = fixture.limits().height_m;
  enemy(0, kTriangle, 0.5f, height - 0.5f).velocity_y = 0.0f;
  EntityRecord& in = world.add(shotAt(rules, 5, 0.6f, height - 1.25f, 1.5707963f));
  in.velocity_y = rules.shot.speed_mps * 2.0f;  // from before the enemy to beyond the wall in one tick
  run();
  EXPECT_EQ(world.byId(0).energy, 0.0f);
  EXPECT_FALSE(has(5));
}

TEST_F(collide, knock_back_is_by_mass) {
  enemy(0, kQuad, x + 1.0f, y);
  enemy(1, kHexagon, x + 1.5f, y + 10.0f);
  shot(10, x, y);
  shot(11, x, y + 10.0f);
  run();
  EXPECT_FLOAT_EQ(world.byId(0).velocity_x, 3.6f / 2.0f);
  EXPECT_FLOAT_EQ(world.byId(1).velocity_x, 3.6f / 8.0f);
  EXPECT_EQ(world.byId(0).flags & kFlagHit, uint32_t(kFlagHit));
}

TEST_F(collide, the_announced_the_dead_and_the_dying_are_not_hit) {
  enemy(0, kTriangle, x + 1.0f, y).birthTick = kLateTick - 29;
  enemy(1, kTriangle, x + 1.0f, y + 5.0f).state = uint32_t(State::dead);
  enemy(2, kTriangle, x + 1.0f, y + 10.0f).energy = 0.0f;
  enemy(3, kTriangle, x + 1.0f, y + 15.0f).birthTick = kLateTick - 30;
  for (uint32_t i = 0; i < 4; ++i) shot(10 + i, x, y + 5.0f * float(i));
  run();
  EXPECT_EQ(world.byId(0).energy, 1.0f);
  EXPECT_EQ(world.byId(1).energy, 1.0f);
  EXPECT_EQ(world.byId(2).energy, 0.0f);
  EXPECT_EQ(world.byId(3).energy, 0.0f);
  for (uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(has(10 + i)) << i;
}

TEST_F(collide, the_costliest_touches_then_the_lowest_id) {
  const float ship_x = world.globals.ship.x, ship_y = world.globals.ship.y;
  enemy(1, kHexagon, ship_x + 1.9f, ship_y);  // 0.25 m too far
  enemy(2, kTriangle, ship_x + 0.5f, ship_y);
  enemy(5, kHexagon, ship_x - 1.5f, ship_y);
  enemy(7, kHexagon, ship_x, ship_y + 1.5f);
  run();
  EXPECT_EQ(contact >> 32, rules.enemies[kHexagon].contact_us);
  ASSERT_GT(rules.enemies[kHexagon].contact_us, rules.enemies[kTriangle].contact_us);
  EXPECT_EQ(~uint32_t(contact), 5u);
  world.globals.ship.untouchable_ticks = 1;
  run();
  EXPECT_EQ(contact, 0u);
}

TEST_F(collide, contact_is_swept_too) {
  Ship& ship = world.globals.ship;
  ship.previous_x = ship.x - 2.0f;  // it flew through where the enemy stands
  enemy(0, kTriangle, ship.x - 1.0f, ship.y);
  run();
  EXPECT_EQ(~uint32_t(contact), 0u);
  EXPECT_NE(contact, 0u);
}

TEST_F(collide, the_blast_ends_the_toucher_and_the_weak_within_five_metres) {
  GameGlobals& m = world.globals;
  m.blast = 1;
  m.blastId = 6;
  enemy(0, kTriangle, m.ship.x + 4.9f, m.ship.y);
  enemy(1, kTriangle, m.ship.x - 5.1f, m.ship.y);
  enemy(2, kHexagon, m.ship.x, m.ship.y + 4.0f);                         // not weak
  enemy(6, kHexagon, m.ship.x, m.ship.y - 20.0f);                        // touched, wherever it is now
  enemy(7, kTriangle, m.ship.x, m.ship.y - 3.0f).birthTick = kLateTick;  // announced
  run();
  for (uint32_t id : {0u, 6u}) {
    EXPECT_EQ(world.byId(id).energy, 0.0f) << id;
    EXPECT_EQ(world.byId(id).flags, kFlagHit | kFlagBlasted) << id;
  }
  EXPECT_EQ(world.byId(1).energy, 1.0f);
  EXPECT_EQ(world.byId(2).energy, 16.0f);
  EXPECT_EQ(world.byId(7).energy, 1.0f);
}

TEST_F(collide, the_flush_ends_whoever_its_ring_has_met) {
  GameGlobals& m = world.globals;
  m.flush_x = m.ship.x - 20.0f;
  m.flush_y = m.ship.y;
  m.flushRadius_m = 10.0f;
  enemy(0, kHexagon, m.flush_x + 11.1f, m.flush_y);
  enemy(1, kHexagon, m.flush_x - 11.3f, m.flush_y);
  run();
  EXPECT_EQ(world.byId(0).energy, 0.0f);
  EXPECT_EQ(world.byId(0).flags, kFlagHit | kFlagFlushed);
  EXPECT_EQ(world.byId(1).energy, 16.0f);
}

TEST_F(collide, nothing_collides_once_the_game_is_over) {
  Dice dice(5);
  addCrowd(world, 100, 60, 10, 6.0f, dice);
  world.globals.over = 1;
  const auto before = world.records();
  run();
  EXPECT_TRUE(same(world.records(), before));
  EXPECT_EQ(contact, 0u);
}

}  // namespace
}  // namespace gw::test
