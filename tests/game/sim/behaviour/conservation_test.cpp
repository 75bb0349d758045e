// What must add up in the running game: the energy that enemies lose is the damage of the shots that hit
// them; what does not fit is refused, and the same in every way of computing it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "tests/game/sim/behaviour/scene.h"

namespace gw::test {
namespace {

using ById = std::map<uint32_t, EntityRecord>;
ById byId(const Snapshot& snapshot) {
  ById all;
  for (const EntityRecord& e : snapshot.entities) all[e.id] = e;
  return all;
}

// The same entity a tick later, or null.
const EntityRecord* later(const ById& all, const EntityRecord& e) {
  const auto found = all.find(e.id);
  return found != all.end() && found->second.type == e.type && found->second.birthTick == e.birthTick ? &found->second
                                                                                                      : nullptr;
}

// Energy that one enemy lost to shots in one tick; what it recovered comes back to the account.
double lostBy(const EntityRecord& before, const EntityRecord& after, const Rules& rules) {
  double had = before.energy;
  if (after.state == uint32_t(State::escaping)) {
    had = std::min(had + rules.steering.recover_per_s * kTick_s, double(rules.enemies[before.type].energy));
  }
  return had - after.energy;
}

// Hits that shots spent in one tick. They end by nothing else in this game; `hits left` is kept in cooldown.
uint64_t spentHits(const ById& before, const ById& after, const TickReport& report, const Rules& rules) {
  uint64_t spent = 0;
  for (const auto& [id, shot] : before) {
    if (shot.type != kTypeShot) continue;
    const EntityRecord* now = later(after, shot);
    EXPECT_TRUE(now || shot.cooldown == 1) << "a shot that could hit again is gone";
    spent += now ? shot.cooldown - now->cooldown : 1;
  }
  uint32_t level = 0, seen = 0;
  while (level + 1 < rules.shot.levelCount && report.multiplierTenths >= rules.shot.levels[level + 1].fromTenths) {
    ++level;
  }
  for (const auto& [id, shot] : after) {
    if (shot.type != kTypeShot || shot.birthTick != report.tick) continue;
    ++seen;
    spent += rules.shot.levels[level].hits - shot.cooldown;
  }
  const uint32_t born = report.sounds[uint32_t(SoundEvent::shot)][1] ? rules.shot.levels[level].count : 0;
  return spent + (born - seen);  // those that hit as they were born and were never seen
}

TEST(energy, that_enemies_lose_is_what_shots_spend) {
  SimulationConfig config = quietConfig();
  config.autopilot = Autopilot::expert;
  config.rules.world.width_m = config.rules.world.height_m = 2000;  // no shot reaches a wall, and none grows old
  config.rules.shot.life_ticks = 10'000;
  config.rules.flush.start = 0;
  std::mt19937_64 random(5);
  std::vector<Place> places;
  for (uint32_t i = 0; i < 300; ++i) {
    places.push_back({i % 7, 980 + float(random() % 40'000) / 1000, 980 + float(random() % 40'000) / 1000});
  }
  const auto simulation = makeScene(config, 1000, 1000, places);

  double lost = 0;
  uint64_t spent = 0, recovering = 0;
  uint32_t kills = 0;
  ById before = byId(simulation->snapshot());
  for (uint32_t t = 0; t < 600; ++t) {
    const TickReport report = playOn(*simulation, 1);
    const ById after = byId(simulation->snapshot());
    double lostNow = 0;
    for (const auto& [id, enemy] : before) {
      if (enemy.type >= kMaxEnemyTypes || enemy.state == uint32_t(State::dead)) continue;
      const EntityRecord* now = later(after, enemy);
      ASSERT_TRUE(now) << "an enemy left without dying";
      lostNow += lostBy(enemy, *now, config.rules);
      recovering += now->state == uint32_t(State::escaping);
    }
    const uint64_t spentNow = spentHits(before, after, report, config.rules);
    ASSERT_NEAR(lostNow, double(spentNow) * config.rules.shot.damage, 1e-4) << "tick " << report.tick;
    lost += lostNow;
    spent += spentNow;
    kills = uint32_t(report.kills);
    before = after;
  }
  EXPECT_NEAR(lost, double(spent) * config.rules.shot.damage, 1e-2);
  EXPECT_GT(spent, 150u);
  EXPECT_GT(kills, 25u);
  EXPECT_GT(recovering, 60u);
}

struct Counts {
  uint32_t peak = 0;
  std::vector<std::tuple<uint32_t, uint32_t, uint64_t>> ticks;  // alive, refused, hash
};

// The arcade's waves at ten times their rate, in a game that holds 256.
Counts crowded(uint32_t threads, VisitOrder order) {
  SimulationConfig config;
  config.rules = gameRules();
  config.enemies = 256;
  config.autopilot = Autopilot::novice;
  config.threads = threads;
  config.order = order;
  config.rules.budget.limit_us = ~0u;  // it ends no game
  for (Wave& wave : config.rules.waves) wave.at_ticks /= 10;
  const auto simulation = cpu::makeSimulation(config);
  Counts counts;
  for (uint32_t t = 0; t < 900; ++t) {
    const TickReport report = playOn(*simulation, 1);
    counts.peak = std::max({counts.peak, report.enemies, report.peakEnemies});
    counts.ticks.emplace_back(report.enemies, report.refused, report.hash);
  }
  return counts;
}

TEST(births, are_refused_at_capacity) {
  const Counts counts = crowded(1, VisitOrder::forward);
  EXPECT_EQ(counts.peak, 256u);
  EXPECT_GT(std::get<1>(counts.ticks.back()), 1000u);
}

TEST(births, are_refused_alike_however_computed) {
  const Counts wanted = crowded(1, VisitOrder::forward);
  EXPECT_EQ(crowded(2, VisitOrder::forward).ticks, wanted.ticks);
  EXPECT_EQ(crowded(5, VisitOrder::forward).ticks, wanted.ticks);
  EXPECT_EQ(crowded(2, VisitOrder::reversed).ticks, wanted.ticks);
  EXPECT_EQ(crowded(2, VisitOrder::shuffled).ticks, wanted.ticks);
}

}  // namespace
}  // namespace gw::test
