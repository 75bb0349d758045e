// Which snapshots of a replay are kept: close enough in ticks and in work, within the budget.
#include "game/replay_viewer/snapshot_cache.h"

#include <gtest/gtest.h>

namespace gw::test {
namespace {

RunSnapshot at(uint32_t tick, size_t entities = 0) {
  RunSnapshot snapshot;
  snapshot.state.entities.resize(entities);
  TickReport report;
  report.tick = tick;
  if (tick > 0) snapshot.monitor.add(report);
  return snapshot;
}

TEST(SnapshotCache, WantsTheFirstThenOneAfterSoManyTicksOrSoMuchWork) {
  SnapshotCache cache(1 << 30, {240, 250});
  EXPECT_TRUE(cache.wanted(0, 0));
  cache.keep(at(0));
  EXPECT_FALSE(cache.wanted(0, 1000)) << "there already";
  EXPECT_FALSE(cache.wanted(239, 249));
  EXPECT_TRUE(cache.wanted(240, 0));
  EXPECT_TRUE(cache.wanted(7, 250)) << "where ticks are slow they are closer";
}

TEST(SnapshotCache, FindsTheLastOneAtOrBefore) {
  SnapshotCache cache;
  EXPECT_EQ(cache.before(5), nullptr);
  for (const uint32_t tick : {0u, 240u, 480u}) cache.keep(at(tick));
  EXPECT_EQ(cache.before(0)->tick(), 0u);
  EXPECT_EQ(cache.before(239)->tick(), 0u);
  EXPECT_EQ(cache.before(240)->tick(), 240u);
  EXPECT_EQ(cache.before(100000)->tick(), 480u);
  EXPECT_EQ(cache.lastTick(), 480u);
}

TEST(SnapshotCache, StartEarlierForTheSparksButNotByMuchWork) {
  SnapshotCache cache;
  for (const uint32_t tick : {0u, 240u, 480u, 500u, 520u, 540u}) cache.keep(at(tick));
  EXPECT_EQ(cache.start(30, 60)->tick(), 0u);
  EXPECT_EQ(cache.start(299, 60)->tick(), 0u);
  EXPECT_EQ(cache.start(300, 60)->tick(), 240u);
  EXPECT_EQ(cache.start(545, 60)->tick(), 500u) << "two back, where they are dense";
  EXPECT_EQ(cache.start(700, 60)->tick(), 540u);
}

TEST(SnapshotCache, ThinsToTwiceTheSpacingAsOftenAsTheBudgetAsks) {
  const size_t each = bytesOf(at(240, 100));
  SnapshotCache cache(each * 8, {240, 250});
  for (uint32_t i = 0; i < 40; ++i) {
    if (cache.wanted(i * 240, 0)) cache.keep(at(i * 240, 100));
    EXPECT_LE(cache.bytes(), each * 8);
    EXPECT_EQ(cache.before(0)->tick(), 0u) << "the start stays";
  }
  EXPECT_EQ(cache.spacing().ticks, 1920u);
  EXPECT_EQ(cache.spacing().cost_ms, 2000);
  for (uint32_t tick = 0; tick < 39 * 240; tick += 100) {
    EXPECT_LE(tick - cache.before(tick)->tick(), 1920u) << "no gap is wider than the spacing";
  }
}

TEST(SnapshotCache, KeepsTheStartWhateverTheBudget) {
  SnapshotCache cache(1, {240, 250});
  cache.keep(at(0, 10));
  cache.keep(at(240, 10));
  cache.keep(at(480, 10));
  EXPECT_EQ(cache.count(), 1u);
  EXPECT_EQ(cache.before(1000)->tick(), 0u);
}

TEST(SnapshotCache, CountsAMomentThatComesTwiceOnce) {
  SnapshotCache cache;
  cache.keep(at(0));
  cache.keep(at(240, 10));
  const size_t bytes = cache.bytes();
  cache.keep(at(240, 10));
  EXPECT_EQ(cache.count(), 2u);
  EXPECT_EQ(cache.bytes(), bytes);
}

}  // namespace
}  // namespace gw::test
