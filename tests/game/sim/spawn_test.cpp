#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "game/sim/behaviour/spawn_patterns.h"
#include "tests/game/sim/random_values.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

constexpr uint32_t kTriangle = 0, kHexagon = 2;

class spawn : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();

  spawn() { world.globals.tick = kLateTick; }

  // What logic would have ordered.
  void order(Command command) {
    command.firstBirth = 0;
    for (const Command& c : world.commands) command.firstBirth += c.count;
    world.commands.push_back(command);
  }
  void order(uint32_t type, uint32_t count, Pattern pattern = Pattern::ring) {
    Command c;
    c.type = type;
    c.count = count;
    c.pattern = pattern;
    c.x = world.globals.ship.x;
    c.y = world.globals.ship.y;
    order(c);
  }
  EntityRecord& dying(uint32_t id, uint32_t type, uint32_t flags = 0) {
    EntityRecord e = enemyAt(rules, id, type, 50.0f + float(id), 40.0f);
    e.state = uint32_t(State::dead);
    e.energy = 0.0f;
    e.flags = flags;
    return world.add(e);
  }

  std::vector<EntityRecord> run() { return run(fixture); }
  std::vector<EntityRecord> run(StageFixture& on) {
    on.put(world);
    TickScratch s = on.scratch();
    s.commandCount = uint32_t(world.commands.size());
    s.births = 0;
    for (uint32_t i = 0; i < s.commandCount; ++i) {
      s.commands[i] = world.commands[i];
      s.births += world.commands[i].count;
    }
    uint32_t bits = 0;
    for (const EntityRecord& e : world.entities) bits += e.type == kTypeBit;
    s.bitRoom = kBitCapacity - bits;
    on.setScratch(s);
    cpu::spawn(on.queue(), on.view(), on.state().birthScan());
    return on.entities(false, false);
  }
};

TEST_F(spawn, is_the_naive_version) {
  for (uint32_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    world.globals.seed = seed;
    world.globals.tick = kLateTick + seed;
    Dice dice(seed);
    addCrowd(world, 60, 20, 30, 30.0f, dice);
    Command salvo;
    salvo.type = kTypeShot;
    salvo.count = 2 + seed % 6;
    salvo.hits = 1 + seed % 3;
    salvo.x = world.globals.ship.x + 0.5f;
    salvo.y = world.globals.ship.y;
    salvo.angle_rad = dice.between(0.0f, 6.2f);
    salvo.spread_rad = seed % 2 ? 0.08f : 0.0f;
    order(salvo);
    for (uint32_t g = 0; g < 3; ++g) {
      order(dice.below(rules.enemyTypeCount), 1 + dice.below(40), Pattern((seed + g) % uint32_t(Pattern::count)));
      world.commands.back().angle_rad = dice.between(0.0f, 6.2f);
    }
    const auto is = run();
    naive::spawn(world);
    EXPECT_TRUE(same(is, world.records()));
    EXPECT_TRUE(same(fixture.globals(), world.globals));
  }
}

// Commands first, in order; then bits by parent; always the lowest ids that were free when the tick began.
TEST_F(spawn, births_take_the_lowest_free_ids_in_order) {
  dying(1, kTriangle);
  dying(4, kHexagon);
  world.add(enemyAt(rules, 6, kTriangle, 30.0f, 30.0f));
  order(kTypeShot, 2);
  order(kTriangle, 3);
  const auto after = run();
  const uint32_t wanted[][2] = {{0, kTypeShot}, {2, kTypeShot}, {3, kTriangle}, {5, kTriangle}, {6, kTriangle},
                                {7, kTriangle}, {8, kTypeBit},  {9, kTypeBit},  {10, kTypeBit}, {11, kTypeBit},
                                {12, kTypeBit}, {13, kTypeBit}, {14, kTypeBit}};
  ASSERT_EQ(after.size(), 13u);
  for (size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].id, wanted[i][0]);
    EXPECT_EQ(after[i].type, wanted[i][1]) << after[i].id;
  }
  EXPECT_EQ(after[6].x, 51.0f);                                  // the triangle's one bit
  for (size_t i = 7; i < 13; ++i) EXPECT_EQ(after[i].x, 54.0f);  // the hexagon's six
}

TEST_F(spawn, newborn_enemies_are_announced_and_wander_towards_the_ship) {
  order(kHexagon, 5);
  for (const EntityRecord& e : run()) {
    EXPECT_EQ(e.birthTick, kLateTick);
    EXPECT_EQ(e.state, uint32_t(State::wandering));
    EXPECT_EQ(e.energy, 16.0f);
    EXPECT_EQ(e.mass, 8.0f);
    EXPECT_EQ(e.previous_x, e.x);
    const float x = world.globals.ship.x - e.x, y = world.globals.ship.y - e.y;
    EXPECT_NEAR(e.direction_x * y - e.direction_y * x, 0.0f, 1e-4f);
    EXPECT_GT(e.direction_x * x + e.direction_y * y, 0.0f);
  }
}

TEST_F(spawn, a_salvo_fans_out_or_flies_abreast) {
  Command salvo;
  salvo.type = kTypeShot;
  salvo.count = 3;
  salvo.hits = 2;
  salvo.x = 90.0f;
  salvo.y = 50.0f;
  salvo.spread_rad = 0.09f;
  order(salvo);
  auto fan = run();
  ASSERT_EQ(fan.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::atan2(fan[k].velocity_y, fan[k].velocity_x), 0.09f * float(k - 1), 1e-6f);
    EXPECT_NEAR(std::hypot(fan[k].velocity_x, fan[k].velocity_y), 45.0f, 1e-4f);
    EXPECT_EQ(fan[k].x, 90.0f);
    EXPECT_EQ(fan[k].cooldown, 2u);
    EXPECT_EQ(fan[k].timer, 48u);
  }
  world.commands[0].count = 2;
  world.commands[0].spread_rad = 0.0f;
  auto pair = run();
  ASSERT_EQ(pair.size(), 2u);
  EXPECT_EQ(pair[0].velocity_y, 0.0f);
  EXPECT_EQ(pair[1].velocity_y, 0.0f);
  EXPECT_NEAR(pair[1].y - pair[0].y, 0.32f, 1e-5f);
}

TEST_F(spawn, flushed_and_blasted_enemies_leave_no_bits) {
  dying(0, kHexagon, kFlagFlushed);
  dying(1, kHexagon, kFlagBlasted);
  EXPECT_TRUE(run().empty());
}

TEST_F(spawn, bits_that_do_not_fit_are_refused_and_counted) {
  for (uint32_t i = 0; i < kBitCapacity - 4; ++i) world.add(bitAt(rules, 10 + i, 20.0f, 20.0f));
  dying(2, kTriangle);
  dying(5, kHexagon);
  world.globals.refused = 100;
  const auto after = run();
  EXPECT_EQ(after.size(), size_t(kBitCapacity));
  EXPECT_EQ(fixture.globals().refused, 103u);
  EXPECT_EQ(after[0].x, 52.0f);  // the lower parent comes first
  EXPECT_EQ(after[1].x, 55.0f);
}

TEST_F(spawn, nobody_is_born_or_leaves_once_the_game_is_over) {
  world.globals.over = 1;
  dying(3, kTriangle);
  order(kTriangle, 5);
  EXPECT_TRUE(same(run(), world.records()));
}

// The places: inside the world, clear of the ship, wherever it is.
void checkPlaces(const Rules& rules, float width_m, float height_m, float ship_x, float ship_y, const Command& command,
                 uint64_t seed) {
  cpu::Tables tables{};
  tables.rules = rules;
  tables.limits.width_m = width_m;
  tables.limits.height_m = height_m;
  naive::World world;
  world.rules = rules;
  world.limits = tables.limits;
  world.globals.seed = seed;
  world.globals.tick = 60;
  Command c = command;
  c.x = ship_x;
  c.y = ship_y;
  for (uint32_t k = 0; k < c.count; ++k) {
    const Float2 place = cpu::birthPosition(c, k, seed, 60, 0, tables);
    RC_ASSERT(place.x >= 1.2f);
    RC_ASSERT(place.x <= width_m - 1.2f);
    RC_ASSERT(place.y >= 1.2f);
    RC_ASSERT(place.y <= height_m - 1.2f);
    const float clear = rules.world.spawnClearance_m;
    RC_ASSERT(std::hypot(double(place.x) - ship_x, double(place.y) - ship_y) >= double(clear) * 0.999999);
    const Float2 wanted = naive::birthPlace(world, c, 0, k);
    RC_ASSERT(place.x == wanted.x);
    RC_ASSERT(place.y == wanted.y);
  }
}

Command someCommand() {
  Command c;
  c.count = 1 + below(300);
  c.pattern = Pattern(below(uint32_t(Pattern::count)));
  c.angle_rad = number(0.0f, 6.28f);
  return c;
}

// Half of the time at a wall or in a corner.
float someShipPlace(float size) {
  return below(2) ? number(0.45f, size - 0.45f) : below(2) ? number(0.45f, 14.0f) : size - number(0.45f, 14.0f);
}

RC_GTEST_PROP(spawn_places, are_inside_and_clear_of_the_ship, ()) {
  checkPlaces(gameRules(), 192.0f, 108.0f, someShipPlace(192.0f), someShipPlace(108.0f), someCommand(),
              below(1u << 30));
}

// The tables allow worlds from 64 m and clearances up to 30 m: the ship can stand where neither the place
// nor its mirror image is clear.
RC_GTEST_PROP(spawn_places, are_clear_of_the_ship_in_the_smallest_world_too, ()) {
  Rules rules = gameRules();
  rules.world.spawnClearance_m = number(12.0f, 30.0f);
  checkPlaces(rules, 64.0f, 64.0f, someShipPlace(64.0f), someShipPlace(64.0f), someCommand(), below(1u << 30));
}

TEST(spawn_places, differ_from_tick_to_tick_and_seed_to_seed) {
  cpu::Tables tables{};
  tables.rules = gameRules();
  tables.limits.width_m = 192.0f;
  tables.limits.height_m = 108.0f;
  Command c;
  c.count = 8;
  c.x = 96.0f;
  c.y = 54.0f;
  std::set<std::pair<float, float>> places;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    for (uint32_t tick = 1; tick <= 3; ++tick) {
      const Float2 p = cpu::birthPosition(c, 0, seed, tick, 0, tables);
      places.insert({p.x, p.y});
    }
  }
  EXPECT_EQ(places.size(), 9u);
}

}  // namespace
}  // namespace gw::test
