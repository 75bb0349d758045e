// Which moments of a replay are kept: close enough in ticks and in work, within the budget.
#include <gtest/gtest.h>

#include "game/replay_viewer/moments.h"

namespace gw::test {
namespace {

RunMoment at(uint32_t tick, size_t entities = 0) {
  RunMoment moment;
  moment.state.entities.resize(entities);
  TickReport report;
  report.tick = tick;
  if (tick > 0) moment.monitor.add(report);
  return moment;
}

TEST(Moments, WantsTheFirstThenOneAfterSoManyTicksOrSoMuchWork) {
  Moments moments(1 << 30, {240, 250});
  EXPECT_TRUE(moments.wanted(0, 0));
  moments.keep(at(0));
  EXPECT_FALSE(moments.wanted(0, 1000)) << "there already";
  EXPECT_FALSE(moments.wanted(239, 249));
  EXPECT_TRUE(moments.wanted(240, 0));
  EXPECT_TRUE(moments.wanted(7, 250)) << "where ticks are slow they are closer";
}

TEST(Moments, FindsTheLastOneAtOrBefore) {
  Moments moments;
  EXPECT_EQ(moments.before(5), nullptr);
  for (const uint32_t tick : {0u, 240u, 480u}) moments.keep(at(tick));
  EXPECT_EQ(moments.before(0)->tick(), 0u);
  EXPECT_EQ(moments.before(239)->tick(), 0u);
  EXPECT_EQ(moments.before(240)->tick(), 240u);
  EXPECT_EQ(moments.before(100000)->tick(), 480u);
  EXPECT_EQ(moments.reach(), 480u);
}

TEST(Moments, StartEarlierForTheSparksButNotByMuchWork) {
  Moments moments;
  for (const uint32_t tick : {0u, 240u, 480u, 500u, 520u, 540u}) moments.keep(at(tick));
  EXPECT_EQ(moments.start(30, 60)->tick(), 0u);
  EXPECT_EQ(moments.start(299, 60)->tick(), 0u);
  EXPECT_EQ(moments.start(300, 60)->tick(), 240u);
  EXPECT_EQ(moments.start(545, 60)->tick(), 500u) << "two back, where they are dense";
  EXPECT_EQ(moments.start(700, 60)->tick(), 540u);
}

TEST(Moments, ThinsToTwiceTheSpacingAsOftenAsTheBudgetAsks) {
  const size_t each = bytesOf(at(240, 100));
  Moments moments(each * 8, {240, 250});
  for (uint32_t i = 0; i < 40; ++i) {
    if (moments.wanted(i * 240, 0)) moments.keep(at(i * 240, 100));
    EXPECT_LE(moments.bytes(), each * 8);
    EXPECT_EQ(moments.before(0)->tick(), 0u) << "the start stays";
  }
  EXPECT_EQ(moments.spacing().ticks, 1920u);
  EXPECT_EQ(moments.spacing().cost_ms, 2000);
  for (uint32_t tick = 0; tick < 39 * 240; tick += 100) {
    EXPECT_LE(tick - moments.before(tick)->tick(), 1920u) << "no gap is wider than the spacing";
  }
}

TEST(Moments, KeepsTheStartWhateverTheBudget) {
  Moments moments(1, {240, 250});
  moments.keep(at(0, 10));
  moments.keep(at(240, 10));
  moments.keep(at(480, 10));
  EXPECT_EQ(moments.count(), 1u);
  EXPECT_EQ(moments.before(1000)->tick(), 0u);
}

TEST(Moments, CountsAMomentThatComesTwiceOnce) {
  Moments moments;
  moments.keep(at(0));
  moments.keep(at(240, 10));
  const size_t bytes = moments.bytes();
  moments.keep(at(240, 10));
  EXPECT_EQ(moments.count(), 2u);
  EXPECT_EQ(moments.bytes(), bytes);
}

}  // namespace
}  // namespace gw::test
