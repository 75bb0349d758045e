// The tables in assets/ say what RULES.md asks for, and equal texts give equal bytes.
#include "game/tables/tables.h"

#include <gtest/gtest.h>

#include <cstring>
#include <new>

namespace gw::test {
namespace {

const RuleTexts& assets() {
  static const RuleTexts texts = readRuleTexts(GW_ASSETS_DIR);
  return texts;
}

TEST(Tables, HoldTheShipsNumbers) {
  const Rules rules = loadRules(assets());
  EXPECT_EQ(rules.world.width_m, 192.0f);
  EXPECT_EQ(rules.world.height_m, 108.0f);
  EXPECT_EQ(rules.world.spawnClearance_m, 12.0f);
  EXPECT_EQ(rules.world.announced_ticks, 30u);
  EXPECT_EQ(rules.ship.radius_m, 0.45f);
  EXPECT_EQ(rules.ship.speed_mps, 16.0f);
  EXPECT_EQ(rules.ship.response, 0.3f);
  EXPECT_EQ(rules.ship.untouchable_ticks, 90u);
  EXPECT_EQ(rules.ship.blast_m, 5.0f);
  EXPECT_EQ(rules.ship.weakEnergy, 4.0f);
}

TEST(Tables, HoldTheBudget) {
  const Rules::Budget budget = loadRules(assets()).budget;
  EXPECT_EQ(budget.start_us, 16667u);
  EXPECT_EQ(budget.limit_us, 83333u);
  EXPECT_EQ(budget.bitReturns_us, 40u);
  EXPECT_EQ(budget.bankFill_us, 6u);
  EXPECT_EQ(budget.bankMax_us, 600u);
  EXPECT_EQ(budget.hitStop_ms, 66u);
}

TEST(Tables, HoldTheShots) {
  const Rules::Shot shot = loadRules(assets()).shot;
  EXPECT_EQ(shot.speed_mps, 45.0f);
  EXPECT_EQ(shot.radius_m, 0.2f);
  EXPECT_EQ(shot.damage, 1.0f);
  EXPECT_EQ(shot.life_ticks, 48u);
  EXPECT_EQ(shot.knockBack_mps, 3.6f);
  ASSERT_EQ(shot.levelCount, 5u);
  const ShotLevel expected[] = {
      {10, 2, 0, 6, 1}, {30, 3, 0.09f, 6, 1}, {100, 4, 0.08f, 5, 1}, {300, 5, 0.08f, 4, 2}, {1000, 7, 0.08f, 4, 3}};
  for (uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(shot.levels[i].fromTenths, expected[i].fromTenths) << i;
    EXPECT_EQ(shot.levels[i].count, expected[i].count) << i;
    EXPECT_EQ(shot.levels[i].spread_rad, expected[i].spread_rad) << i;
    EXPECT_EQ(shot.levels[i].every_ticks, expected[i].every_ticks) << i;
    EXPECT_EQ(shot.levels[i].hits, expected[i].hits) << i;
  }
}

TEST(Tables, HoldBitsFlushSteeringAndIdle) {
  const Rules rules = loadRules(assets());
  EXPECT_EQ(rules.bit.life_ticks, 360u);
  EXPECT_EQ(rules.bit.speed_mps, 22.0f);
  EXPECT_EQ(rules.bit.attract_m, 5.0f);
  EXPECT_EQ(rules.bit.take_m, 1.0f);
  EXPECT_EQ(rules.bit.multiplierTenths, 1u);
  EXPECT_EQ(rules.flush.start, 3u);
  EXPECT_EQ(rules.flush.most, 5u);
  EXPECT_EQ(rules.flush.speed_mps, 80.0f);
  EXPECT_EQ(rules.flush.reach_m, 36.0f);
  EXPECT_EQ(rules.flush.untouchable_ticks, 60u);
  ASSERT_EQ(rules.flush.scoreCount, kMaxFlushScores);
  EXPECT_EQ(rules.flush.scores[0], 100'000u);
  EXPECT_EQ(rules.flush.scores[3], 3'000'000u);
  EXPECT_EQ(rules.flush.scores[15], 3'000'000'000'000u);
  EXPECT_EQ(rules.steering.response, 0.08f);
  EXPECT_EQ(rules.steering.wanderSpeed, 0.6f);
  EXPECT_EQ(rules.steering.wanderDrift_rad, 0.12f);
  EXPECT_EQ(rules.steering.wanderToShip, 0.35f);
  EXPECT_EQ(rules.steering.damagedSpeed, 1.25f);
  EXPECT_EQ(rules.steering.separation_mps, 6.0f);
  EXPECT_EQ(rules.steering.press_mps, 4.0f);
  EXPECT_EQ(rules.steering.sightLost, 1.25f);
  EXPECT_EQ(rules.idle.fewerThan, 8u);
  EXPECT_EQ(rules.idle.halfWidth_m, 36.0f);
  EXPECT_EQ(rules.idle.halfHeight_m, 20.0f);
  EXPECT_EQ(rules.idle.wait_ticks, 30u);
  EXPECT_EQ(rules.idle.pays, 50u);
}

TEST(Tables, HoldTheEnemyTypes) {
  const Rules rules = loadRules(assets());
  ASSERT_EQ(rules.enemyTypeCount, 7u);
  const EnemyRules& triangle = rules.enemies[0];
  EXPECT_STREQ(triangle.name, "triangle");
  EXPECT_EQ(triangle.machine, Machine::kamikaze);
  EXPECT_EQ(triangle.bounds, Bounds::circle);
  EXPECT_EQ(triangle.halfWidth_m, 0.5f);
  EXPECT_EQ(triangle.halfHeight_m, 0.5f);
  EXPECT_EQ(triangle.vision_m, 4.0f);
  EXPECT_EQ(triangle.shape, Shape::triangle);

  const EnemyRules& quad = rules.enemies[1];
  EXPECT_STREQ(quad.name, "quad");
  EXPECT_EQ(quad.bounds, Bounds::rectangle);
  EXPECT_EQ(quad.halfWidth_m, 0.55f);
  EXPECT_EQ(quad.halfHeight_m, 0.55f);
  EXPECT_EQ(quad.speed_mps, 9.5f);
  EXPECT_EQ(quad.sight_m, 24.0f);
  EXPECT_EQ(quad.shape, Shape::square);

  const EnemyRules& hexagon = rules.enemies[2];
  EXPECT_STREQ(hexagon.name, "hexagon");
  EXPECT_EQ(hexagon.halfWidth_m, 1.2f);
  EXPECT_EQ(hexagon.energy, 16.0f);
  EXPECT_EQ(hexagon.mass, 8.0f);
  EXPECT_GT(hexagon.contact_us, triangle.contact_us);  // how much is a question of balance
  EXPECT_EQ(hexagon.value, 150u);
  EXPECT_EQ(hexagon.bits, 6u);
  EXPECT_EQ(hexagon.shape, Shape::hexagon);
  EXPECT_EQ(hexagon.colour, 0xff3030u);
  EXPECT_EQ(hexagon.avoidCooldown_ticks, 0u);  // a kamikaze does not dodge

  const char* const names[] = {"vertex", "texel", "fragment", "compute"};
  const Machine machines[] = {Machine::group, Machine::group, Machine::tricky, Machine::tricky};
  const Shape shapes[] = {Shape::dart, Shape::checkered, Shape::star, Shape::doubleRing};
  for (uint32_t i = 0; i < 4; ++i) {
    const EnemyRules& enemy = rules.enemies[3 + i];
    EXPECT_STREQ(enemy.name, names[i]);
    EXPECT_EQ(enemy.machine, machines[i]);
    EXPECT_EQ(enemy.shape, shapes[i]);
    EXPECT_EQ(enemy.avoidCooldown_ticks, i == 0 ? 240u : 90u);
  }
}

TEST(Tables, HoldWhatGroupAndTrickyDo) {
  const Rules::Steering steering = loadRules(assets()).steering;
  EXPECT_EQ(steering.cohesion, 0.5f);
  EXPECT_EQ(steering.alignment, 0.6f);
  EXPECT_EQ(steering.attackAlignment, 0.3f);
  EXPECT_EQ(steering.sideways, 0.7f);
  EXPECT_EQ(steering.sidewaysBeyond_m, 10.0f);
  EXPECT_EQ(steering.threat_m, 6.0f);
  EXPECT_EQ(steering.threatMargin_m, 0.5f);
  EXPECT_EQ(steering.avoid_mps, 15.0f);
  EXPECT_EQ(steering.avoidResponse, 0.5f);
  EXPECT_EQ(steering.avoid_ticks, 12u);
  EXPECT_EQ(steering.escapeBelow, 0.4f);
  EXPECT_EQ(steering.recoveredAt, 0.9f);
  EXPECT_EQ(steering.recover_per_s, 1.0f);
  EXPECT_EQ(steering.escapeSpeed, 1.1f);
}

TEST(Tables, HoldWhatTheModesDoOtherwise) {
  const Rules rules = loadRules(assets());
  EXPECT_EQ(rules.deadline.clock_ticks, 180u * kTicksPerSecond);
  EXPECT_EQ(rules.deadline.waveRate, 2u);
  EXPECT_EQ(rules.deadline.contactTicks_per_ms, 18u);
  EXPECT_EQ(rules.swarm.clearance_m, 30.0f);
  EXPECT_EQ(rules.swarm.multiplierTenths, 100u);
  EXPECT_EQ(rules.swarm.attackShare, 0.01f);
}

TEST(Tables, HoldALivelyTimetable) {
  const Rules rules = loadRules(assets());
  ASSERT_GE(rules.waveCount, 10u);
  EXPECT_EQ(rules.waves[0].at_ticks, 0u);
  EXPECT_GT(rules.waves[0].groups[0].count, 0u);
  EXPECT_EQ(rules.waves[0].groups[0].pattern, Pattern::ring);
  uint32_t enemies = 0;
  for (uint32_t i = 0; i < rules.waveCount; ++i) {
    const Wave& wave = rules.waves[i];
    for (uint32_t g = 0; g < wave.groupCount; ++g) enemies += wave.groups[g].count;
    const uint32_t next_ticks = i + 1 < rules.waveCount ? rules.waves[i + 1].at_ticks : rules.endless.from_ticks;
    EXPECT_LE(next_ticks - wave.at_ticks, 15 * kTicksPerSecond) << "a gap after wave " << i;
  }
  EXPECT_GT(enemies, 2000u);
}

TEST(Tables, HoldTheEndlessWaves) {
  const Rules::Endless endless = loadRules(assets()).endless;
  EXPECT_EQ(endless.from_ticks, 180u * kTicksPerSecond);
  EXPECT_EQ(endless.every_ticks, 13u * kTicksPerSecond);
  EXPECT_EQ(endless.paceGrowth, 1.035f);
  EXPECT_EQ(endless.paceMost, 2.0f);
  EXPECT_GE(endless.points, 100.0f);  // how many is a question of balance...
  EXPECT_GT(endless.growth, 1.0f);    // ...that it grows is not
  EXPECT_EQ(endless.price[2], 8.0f);
  EXPECT_EQ(endless.price[3], 0.5f);
  uint32_t sum_percent = 0;
  for (const uint32_t chance : endless.chance_percent) sum_percent += chance;
  EXPECT_EQ(sum_percent, 100u);
}

// The rules are hashed as bytes: whatever lay in memory before must not show through.
TEST(Tables, EqualTextsGiveEqualBytes) {
  alignas(Rules) unsigned char memory[2][sizeof(Rules)];
  std::memset(memory[0], 0x00, sizeof(Rules));
  std::memset(memory[1], 0xff, sizeof(Rules));
  for (auto& place : memory) new (place) Rules(loadRules(assets()));
  EXPECT_EQ(std::memcmp(memory[0], memory[1], sizeof(Rules)), 0);
}

TEST(Tables, UnusedEntriesAndNamesArePaddedWithZeros) {
  const Rules rules = loadRules(assets());
  const EnemyRules nothing{};
  EXPECT_EQ(std::memcmp(&rules.enemies[7], &nothing, sizeof nothing), 0);
  for (size_t i = 5; i < sizeof rules.enemies[1].name; ++i) EXPECT_EQ(rules.enemies[1].name[i], 0) << i;
}

TEST(Tables, TextsCarryTheNamesOfTheirFiles) {
  EXPECT_EQ(assets().waves.name, std::string(GW_ASSETS_DIR) + "/waves.toml");
}

}  // namespace
}  // namespace gw::test
