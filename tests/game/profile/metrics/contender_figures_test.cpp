// From runs to what the report says of a contender.
#include "game/profile/metrics/contender_figures.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "tests/game/profile/metrics/noise.h"

namespace gw::profile::test {
namespace {

// Every frame a tick of `time_ms`, all but the first 60 counting; every 30th timed by stages.
RunFrames runOf(uint32_t frames, double time_ms, uint32_t live = 100) {
  RunFrames run;
  run.stages = {"maintain", "think"};
  for (uint32_t tick = 1; tick <= frames; ++tick) {
    Frame frame;
    frame.tick = tick;
    frame.ticks = 1;
    frame.total_ms = frame.simulation_ms = tick <= 60 ? 50 * time_ms : time_ms;
    frame.live = live;
    frame.warmUp = tick <= 60;
    frame.staged = tick % 30 == 0;
    if (frame.staged) frame.stages_ms = {float(tick <= 60 ? 99 : time_ms / 4), float(tick <= 60 ? 99 : time_ms / 2)};
    if (frame.staged) frame.gather_ms = time_ms;
    run.frames.push_back(frame);
  }
  return run;
}

Contender contenderOf(const std::string& name, const std::vector<RunFrames>& runs) {
  ContenderFigures figures(name, "about " + name);
  for (const RunFrames& run : runs) figures.add(run);
  return figures.finish();
}

TEST(ContenderFigures, KeepRunsAndTheirMeans) {
  std::vector<RunFrames> runs;
  for (int run = 0; run < 10; ++run) runs.push_back(runOf(180, 4 + run % 2 * 2));
  const Contender contender = contenderOf("ngrid", runs);
  EXPECT_EQ(contender.name, "ngrid");
  EXPECT_EQ(contender.about, "about ngrid");
  EXPECT_FALSE(contender.shadow);
  ASSERT_EQ(contender.runs.size(), 10u);
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ(contender.runs[i], metricsOf(runs[i]));
  const Estimate tick_ms = contender.overall.at("tick_ms.mean");
  EXPECT_DOUBLE_EQ(tick_ms.value, 5);
  EXPECT_GT(tick_ms.low, 4);
  EXPECT_LT(tick_ms.low, 5);
  EXPECT_LT(tick_ms.high, 6);
  EXPECT_FALSE(contender.overall.contains("draw_ms.mean"));
  EXPECT_EQ(contender.stages, (std::vector<std::string>{"maintain", "think"}));
  EXPECT_EQ(contender.stages_ms, (std::vector<double>{1.25, 2.5}));
  EXPECT_DOUBLE_EQ(contender.overall.at("upkeep_ms.mean").value, contender.stages_ms[0]);
}

TEST(ContenderFigures, OfFewRunsHaveNoInterval) {
  const Contender contender = contenderOf("ngrid", {runOf(120, 4), runOf(120, 6)});
  EXPECT_DOUBLE_EQ(contender.overall.at("frame_ms.mean").value, 5);
  EXPECT_TRUE(std::isnan(contender.overall.at("frame_ms.mean").low));
}

TEST(ContenderFigures, OfNoRuns) {
  const Contender contender = contenderOf("ngrid", {});
  EXPECT_TRUE(contender.runs.empty());
  EXPECT_TRUE(contender.overall.empty());
  EXPECT_TRUE(contender.histogram.empty());
  EXPECT_TRUE(contender.percentiles.empty());
  EXPECT_TRUE(contender.seconds.empty());
}

TEST(ContenderFigures, BinSecondsBySixtyTicks) {
  RunFrames slow = runOf(185, 20, 80);
  slow.frames[119].live = 140;  // tick 120: the last of the second second
  const Contender contender = contenderOf("ngrid", {runOf(185, 10, 80), slow});
  ASSERT_EQ(contender.seconds.size(), 3u);  // the first is warm-up
  const Second& second = contender.seconds[0];
  EXPECT_EQ(second.time_s, 1);
  EXPECT_DOUBLE_EQ(second.fps.value, 75);
  EXPECT_DOUBLE_EQ(second.fps.low, 50);
  EXPECT_DOUBLE_EQ(second.fps.high, 100);
  EXPECT_DOUBLE_EQ(second.live, 80.5);
  EXPECT_EQ(second.stages_ms, (std::vector<double>{3.75, 7.5}));
  EXPECT_EQ(contender.seconds[2].time_s, 3);  // ticks 181 to 185
  EXPECT_TRUE(contender.seconds[2].stages_ms.empty());
  EXPECT_DOUBLE_EQ(contender.seconds[2].live, 80);
}

TEST(ContenderFigures, DisturbedFramesTellStagesAlone) {
  RunFrames run = runOf(180, 4);
  for (Frame& frame : run.frames) {
    frame.disturbed = frame.staged;
    if (frame.staged) frame.total_ms = frame.simulation_ms = 1e6;
  }
  const Contender contender = contenderOf("ngrid", {run});
  EXPECT_EQ(contender.stages_ms, (std::vector<double>{1, 2}));
  ASSERT_EQ(contender.seconds.size(), 2u);
  EXPECT_EQ(contender.seconds[0].stages_ms, (std::vector<double>{1, 2}));
  EXPECT_DOUBLE_EQ(contender.seconds[0].fps.value, 250);
  EXPECT_DOUBLE_EQ(contender.overall.at("frame_ms.longest").value, 4);
  EXPECT_LT(contender.histogram.back().to_ms, 10);
}

TEST(ContenderFigures, TakeMediansOverLiveEnemies) {
  RunFrames run = runOf(60, 1);
  run.frames.clear();
  for (uint32_t i = 0; i < 300; ++i) {
    Frame frame;
    frame.tick = i + 1;
    frame.ticks = 1;
    frame.live = i < 100 ? 64 : i < 200 ? 128 : i < 290 ? 256 : 0;
    frame.total_ms = frame.simulation_ms = frame.live / 64.0 + (i % 10 == 0 ? 500 : 0);  // stalls
    run.frames.push_back(frame);
  }
  for (uint32_t i = 0; i < 9; ++i) run.frames[i].live = 1000;  // too few for a median
  const Contender contender = contenderOf("ngrid", {run});
  ASSERT_EQ(contender.tickOverLive.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(contender.tickOverLive[i].x, double(64 << i));
    EXPECT_DOUBLE_EQ(contender.tickOverLive[i].y, double(1 << i));
  }
}

TEST(ContenderFigures, CountTicksOfOneFrameOneByOne) {
  RunFrames run = runOf(70, 10, 100);
  for (Frame& frame : run.frames) frame.ticks = 0;
  run.frames[60].ticks = 4;
  run.frames[60].simulation_ms = 40;
  run.frames[61].ticks = 3;
  run.frames[61].simulation_ms = 3;
  run.frames[62].ticks = 3;
  run.frames[62].simulation_ms = 6;
  const Contender contender = contenderOf("ngrid", {run});  // ticks of 10, 10, 10, 10, 1, 1, 1, 2, 2, 2
  ASSERT_EQ(contender.tickOverLive.size(), 1u);
  EXPECT_DOUBLE_EQ(contender.tickOverLive[0].y, 2);
}

TEST(ContenderFigures, OfShadowsHoldUpkeepAndGathering) {
  RunFrames run = runOf(120, 4);
  run.shadow = true;
  for (Frame& frame : run.frames) frame.total_ms = kUnknown;
  const Contender contender = contenderOf("uniform", {run, run});
  EXPECT_TRUE(contender.shadow);
  EXPECT_EQ(contender.stages_ms[0], 1);
  EXPECT_DOUBLE_EQ(contender.overall.at("upkeepAndGathering_ms.mean").value, 5);
  EXPECT_TRUE(contender.seconds.empty());
  EXPECT_TRUE(contender.histogram.empty());
  EXPECT_TRUE(contender.percentiles.empty());
  EXPECT_TRUE(contender.tickOverLive.empty());
}

TEST(ContenderFigures, RefuseRunsOfAnotherKind) {
  ContenderFigures figures("ngrid", "");
  figures.add(runOf(120, 4));
  RunFrames stages = runOf(120, 4), shadow = runOf(120, 4), plain = runOf(120, 4);
  stages.stages = {"think", "maintain"};
  shadow.shadow = true;
  plain.stages.clear();
  EXPECT_THROW(figures.add(stages), std::invalid_argument);
  EXPECT_THROW(figures.add(shadow), std::invalid_argument);
  EXPECT_NO_THROW(figures.add(plain));  // timed by no stages at all
  EXPECT_EQ(figures.finish().runs.size(), 2u);
}

// ---------------------------------------------------------------- histogram and percentiles

std::vector<float> someTimes() {
  std::vector<float> times_ms;
  const uint32_t spread = *rc::gen::inRange(1u, 6u);
  const uint64_t seed = *rc::gen::arbitrary<uint64_t>();
  Noise noise(seed);
  for (int i = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 3000)); i > 0; --i) {
    times_ms.push_back(float(std::exp(noise.normal(2, double(spread * spread) / 8))));
  }
  return times_ms;
}

RC_GTEST_PROP(Histogram, holdsEveryFrameInItsBin, ()) {
  const std::vector<float> times_ms = someTimes();
  const std::vector<Bin> bins = histogramOf(times_ms);
  RC_ASSERT(!bins.empty());
  const double ratio = bins[0].to_ms / bins[0].from_ms;
  for (size_t i = 0; i < bins.size(); ++i) {
    uint64_t inside = 0;
    for (const float time_ms : times_ms) inside += bins[i].from_ms <= time_ms && time_ms < bins[i].to_ms;
    RC_ASSERT(bins[i].frames == inside);
    RC_ASSERT(std::abs(bins[i].to_ms / bins[i].from_ms / ratio - 1) < 1e-9);
    if (i > 0) RC_ASSERT(bins[i].from_ms == bins[i - 1].to_ms);
  }
  RC_ASSERT(bins.front().frames > 0u);
  RC_ASSERT(bins.back().frames > 0u);
  RC_ASSERT(std::accumulate(bins.begin(), bins.end(), uint64_t(0),
                            [](uint64_t n, const Bin& b) { return n + b.frames; }) == times_ms.size());
  RC_ASSERT(bins.size() <= 80u);
}

TEST(Histogram, FitsWhatThereIs) {
  std::vector<float> narrow, wide;
  for (int i = 0; i < 10000; ++i) {
    narrow.push_back(16.0f + float(i) / 10000);
    wide.push_back(0.1f * std::pow(10.0f, float(i) / 2500));
  }
  for (const auto& times_ms : {narrow, wide}) {
    const size_t bins = histogramOf(times_ms).size();
    EXPECT_GE(bins, 8u);
    EXPECT_LE(bins, 80u);
  }
  EXPECT_EQ(histogramOf(std::vector<float>(50, 16.7f)).size(), 1u);
  EXPECT_EQ(histogramOf(std::vector<float>{0.0f}).size(), 1u);  // the clock saw no time pass
  EXPECT_TRUE(histogramOf({}).empty());
}

// Just at an edge, a frame belongs to the bin that begins there.
TEST(Histogram, PlacesPowersOfTenAtTheirEdges) {
  for (const float power : {1.0f, 10.0f, 100.0f, 1000.0f, 10000.0f}) {
    const std::vector<Bin> bins = histogramOf(std::vector<float>(50, power));
    ASSERT_EQ(bins.size(), 1u);
    EXPECT_EQ(bins[0].from_ms, power);
    const float less = std::nextafter(power, 0.0f);
    EXPECT_EQ(histogramOf(std::vector<float>{less})[0].to_ms, power);
  }
}

std::vector<double> percentsOf(size_t frames) {
  std::vector<double> percents;
  for (const CurvePoint& point : percentilesOf(std::vector<float>(frames, 5.0f))) {
    EXPECT_EQ(point.y, 5);
    percents.push_back(point.x);
  }
  return percents;
}

TEST(Percentiles, GoAsFarAsFramesDo) {
  EXPECT_TRUE(percentsOf(0).empty());
  EXPECT_EQ(percentsOf(1), (std::vector<double>{0, 100}));
  EXPECT_EQ(percentsOf(10).size(), 92u);  // 0 to 90, and 100
  EXPECT_EQ(percentsOf(100).size(), 101u);
  EXPECT_EQ(percentsOf(199).size(), 101u);
  EXPECT_EQ(percentsOf(200).size(), 102u);
  EXPECT_EQ(percentsOf(999).size(), 102u);
  EXPECT_EQ(percentsOf(1000).size(), 103u);
  EXPECT_EQ(percentsOf(10000).size(), 104u);
  EXPECT_EQ(percentsOf(10000)[102], 99.99);
}

TEST(Percentiles, AreThoseOfTheSeries) {
  std::vector<float> times_ms;
  for (int i = 1000; i >= 0; --i) times_ms.push_back(float(i));
  for (const CurvePoint& point : percentilesOf(times_ms)) EXPECT_NEAR(point.y, 10 * point.x, 1e-9);
}

// ---------------------------------------------------------------- contenders

TEST(SpeedUp, IsHowMuchLongerTheOtherTakes) {
  Noise noise(4);
  std::vector<RunFrames> fast, slow;
  for (int run = 0; run < 12; ++run) {
    const double drift = 1 + 0.1 * run;
    fast.push_back(runOf(120, 4 * drift * noise.normal(1, 0.01)));
    slow.push_back(runOf(120, 10 * drift * noise.normal(1, 0.01)));
  }
  const Contender first = contenderOf("ngrid", fast), other = contenderOf("uniform", slow);
  const SpeedUp speedUp = speedUpOf(first, other);
  EXPECT_EQ(speedUp.contender, "uniform");
  for (const Estimate& estimate : {speedUp.tick, speedUp.frame, speedUp.upkeepAndGathering}) {
    EXPECT_NEAR(estimate.value, 2.5, 0.03);
    EXPECT_LT(estimate.low, 2.5);
    EXPECT_GT(estimate.high, 2.5);
    EXPECT_LT(estimate.high - estimate.low, 0.1);  // drift is cancelled
  }
  EXPECT_LT(speedUpOf(other, first).tick.high, 1);
}

TEST(SpeedUp, PairsRunsOfAnInterruptedSession) {
  std::vector<RunFrames> fast(11, runOf(120, 4)), slow(10, runOf(120, 8));
  fast.push_back(runOf(120, 4000));
  const Contender a = contenderOf("a", fast), b = contenderOf("b", slow);
  EXPECT_DOUBLE_EQ(speedUpOf(a, b).tick.value, 2);
  EXPECT_DOUBLE_EQ(speedUpOf(a, b).tick.low, 2);
  EXPECT_DOUBLE_EQ(speedUpOf(b, a).tick.value, 0.5);
  EXPECT_DOUBLE_EQ(speedUpOf(b, a).tick.high, 0.5);
}

TEST(SpeedUp, OfAShadowIsOfUpkeepAndGatheringAlone) {
  RunFrames shadow = runOf(120, 8);
  shadow.shadow = true;
  const SpeedUp speedUp = speedUpOf(contenderOf("a", {runOf(120, 4)}), contenderOf("b", {shadow}));
  EXPECT_DOUBLE_EQ(speedUp.upkeepAndGathering.value, 2);
  EXPECT_TRUE(std::isnan(speedUp.tick.value));
  EXPECT_TRUE(std::isnan(speedUp.frame.value));
}

TEST(GrowthOf, FitsEveryContenderOverAllCases) {
  std::vector<Case> cases;
  RunFrames shadow = runOf(120, 1);
  shadow.shadow = true;
  for (const uint32_t enemies : {256u, 1024u, 4096u}) {
    Case one;
    one.enemies = enemies;
    one.contenders.push_back(contenderOf("linear", {runOf(120, enemies * 0.001, enemies)}));
    one.contenders.push_back(contenderOf("square", {runOf(120, enemies * 0.001 * enemies, enemies)}));
    if (enemies == 4096) one.contenders.push_back(contenderOf("late", {runOf(120, 3, enemies)}));
    one.contenders.push_back(contenderOf("shadow", {shadow}));
    cases.push_back(one);
  }
  const std::vector<Growth> growth = growthOf(cases);
  ASSERT_EQ(growth.size(), 4u);
  EXPECT_EQ(growth[0].contender, "linear");
  ASSERT_TRUE(growth[0].fit && growth[1].fit);
  EXPECT_NEAR(growth[0].fit->exponent, 1, 1e-3);
  EXPECT_NEAR(growth[1].fit->exponent, 2, 1e-3);
  EXPECT_TRUE(growth[0].why.empty());
  EXPECT_FALSE(growth[2].fit);
  EXPECT_NE(growth[2].why.find("shadow"), std::string::npos);
  EXPECT_EQ(growth[3].contender, "late");
  EXPECT_FALSE(growth[3].fit);
  EXPECT_NE(growth[3].why.find("Too few"), std::string::npos);
  EXPECT_TRUE(growthOf({}).empty());
}

}  // namespace
}  // namespace gw::profile::test
