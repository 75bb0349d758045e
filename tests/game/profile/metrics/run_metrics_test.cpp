// The metrics of one run, from frames whose figures are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "game/profile/metrics/metrics.h"
#include "tests/game/profile/metrics/noise.h"

namespace gw::profile::test {
namespace {

RunFrames runOf(const std::vector<double>& times_ms) {
  RunFrames run;
  run.drawn = true;
  uint32_t tick = 0;
  for (const double time_ms : times_ms) {
    Frame frame;
    frame.tick = ++tick;
    frame.ticks = 1;
    frame.simulation_ms = time_ms / 2;
    frame.total_ms = time_ms;
    run.frames.push_back(frame);
  }
  return run;
}

std::set<std::string> namesOf(const MetricValues& values) {
  std::set<std::string> names;
  for (const auto& [name, value] : values) {
    EXPECT_NO_THROW(metric(name));
    EXPECT_TRUE(std::isfinite(value)) << name;
    names.insert(name);
  }
  return names;
}

// Ten frames with all that can be measured, after one of warm-up that would spoil every figure.
RunFrames wholeRun() {
  RunFrames run = runOf(std::vector<double>(11, 10.0));
  run.stages = {"logic", "maintain", "think"};
  run.timeToFirstFrame_ms = 321;
  run.droppedTicks = 7;
  run.launchesPerTick = 24;
  for (Frame& frame : run.frames) {
    frame.draw_ms = 2;
    frame.wait_ms = 3;
    frame.gl_ms = 1.5;
    frame.latency_ms = 20;
    frame.live = 100;
  }
  run.frames[0].warmUp = true;
  run.frames[0].total_ms = run.frames[0].simulation_ms = run.frames[0].draw_ms = 4000;
  run.frames[0].live = 1;
  run.frames[0].gather_ms = 4000;
  run.frames[0].staged = true;
  run.frames[0].stages_ms = {4000, 4000, 4000};
  Frame& first = run.frames[2];
  first.staged = true;
  first.stages_ms = {0.5f, 1.0f, 2.0f};
  first.candidates = 900;
  first.neighbours = 300;
  first.searching = 100;
  first.gather_ms = 4;
  Frame& second = run.frames[6];
  second.staged = true;
  second.stages_ms = {0.5f, 2.0f, 3.0f};
  second.candidates = 100;
  second.neighbours = 50;
  second.searching = 25;
  second.gather_ms = 6;
  run.frames[10].live = 40;
  return run;
}

TEST(RunMetrics, OfAWholeRunAreAllOfTheTable) {
  const MetricValues values = metricsOf(wholeRun());
  std::set<std::string> all;
  for (const Metric& m : metrics()) all.insert(m.name);
  EXPECT_EQ(namesOf(values), all);
}

TEST(RunMetrics, AreAsDefined) {
  MetricValues values = metricsOf(wholeRun());
  EXPECT_DOUBLE_EQ(values["meanFps"], 100);
  EXPECT_DOUBLE_EQ(values["frame_ms.mean"], 10);
  EXPECT_DOUBLE_EQ(values["frame_ms.longest"], 10);
  EXPECT_DOUBLE_EQ(values["ticksPerSecond"], 200);
  EXPECT_DOUBLE_EQ(values["tick_ms.mean"], 5);
  EXPECT_DOUBLE_EQ(values["ticksPerFrame.mean"], 1);
  EXPECT_DOUBLE_EQ(values["droppedTicks"], 7);
  EXPECT_DOUBLE_EQ(values["launchesPerTick"], 24);
  EXPECT_DOUBLE_EQ(values["draw_ms.mean"], 2);
  EXPECT_DOUBLE_EQ(values["wait_ms.mean"], 3);
  EXPECT_DOUBLE_EQ(values["gl_ms.mean"], 1.5);
  EXPECT_DOUBLE_EQ(values["latency_ms.p50"], 20);
  EXPECT_DOUBLE_EQ(values["upkeep_ms.mean"], 1.5);
  EXPECT_DOUBLE_EQ(values["think_ms.mean"], 2.5);
  EXPECT_DOUBLE_EQ(values["gathering_ms.mean"], 5);
  EXPECT_DOUBLE_EQ(values["upkeepAndGathering_ms.mean"], 6.5);
  EXPECT_DOUBLE_EQ(values["candidatesPerEntity"], 8);  // 1000 of 125, not the mean of 9 and 4
  EXPECT_DOUBLE_EQ(values["neighboursPerEntity"], 2.8);
  EXPECT_DOUBLE_EQ(values["liveEntities.mean"], 94);
  EXPECT_DOUBLE_EQ(values["liveEntities.least"], 40);
  EXPECT_DOUBLE_EQ(values["timeToFirstFrame_ms"], 321);
  EXPECT_DOUBLE_EQ(values["worstOfFirst5s_ms"], 4000);
}

// Twenty seconds at 60 Hz, and four times half a second.
TEST(RunMetrics, ShowStalls) {
  std::vector<double> times_ms(1198, 16.7);
  MetricValues calm = metricsOf(runOf(times_ms));
  for (const size_t at : {100u, 400u, 700u, 1100u}) times_ms[at] = 500;
  MetricValues stalled = metricsOf(runOf(times_ms));

  EXPECT_EQ(calm["stutters"], 0);
  EXPECT_EQ(calm["framesOver16_7ms"], 0);
  EXPECT_NEAR(calm["onePercentLow_fps"], 59.88, 0.01);
  EXPECT_NEAR(calm["onePercentLowMean_fps"], 59.88, 0.01);

  EXPECT_EQ(stalled["stutters"], 4);
  EXPECT_EQ(stalled["framesOver33_3ms"], 4);
  EXPECT_EQ(stalled["framesOver16_7ms"], 4);
  EXPECT_EQ(stalled["frame_ms.longest"], 500);
  EXPECT_EQ(stalled["frame_ms.p50"], calm["frame_ms.p50"]);
  EXPECT_EQ(stalled["tick_ms.p50"], calm["tick_ms.p50"]);
  EXPECT_GT(stalled["frame_ms.p99.9"], 499);
  // Four of 1198 are no hundredth: the percentile does not see them, the mean of the worst twelve does.
  EXPECT_EQ(stalled["onePercentLow_fps"], calm["onePercentLow_fps"]);
  EXPECT_NEAR(stalled["onePercentLowMean_fps"], 1e3 / ((4 * 500 + 8 * 16.7) / 12), 1e-9);
  EXPECT_LT(stalled["meanFps"], 55);
}

// The same four stalls in a run so short that they are a hundredth of it: both ways see them.
TEST(RunMetrics, ShowStallsInBothWaysOfOnePercentLow) {
  std::vector<double> times_ms(300, 16.7);
  for (const size_t at : {50u, 120u, 190u, 260u}) times_ms[at] = 500;
  MetricValues values = metricsOf(runOf(times_ms));
  EXPECT_DOUBLE_EQ(values["onePercentLow_fps"], 2);
  EXPECT_DOUBLE_EQ(values["onePercentLowMean_fps"], 2);
  EXPECT_EQ(values["frame_ms.p50"], 16.7);
}

TEST(RunMetrics, OfNoFrames) {
  EXPECT_TRUE(metricsOf({}).empty());
  RunFrames run;
  run.timeToFirstFrame_ms = 12;
  EXPECT_EQ(namesOf(metricsOf(run)), (std::set<std::string>{"timeToFirstFrame_ms"}));
}

TEST(RunMetrics, OfWarmUpAlone) {
  RunFrames run = wholeRun();
  for (Frame& frame : run.frames) frame.warmUp = true;
  const MetricValues values = metricsOf(run);
  EXPECT_EQ(namesOf(values), (std::set<std::string>{"timeToFirstFrame_ms", "worstOfFirst5s_ms"}));
  EXPECT_EQ(values.at("worstOfFirst5s_ms"), 4000);
}

TEST(RunMetrics, OfOneFrame) {
  MetricValues values = metricsOf(runOf({20}));
  EXPECT_EQ(values["meanFps"], 50);
  EXPECT_EQ(values["frame_ms.p50"], 20);
  EXPECT_EQ(values["frame_ms.p99.9"], 20);
  EXPECT_EQ(values["onePercentLow_fps"], 50);
  EXPECT_EQ(values["onePercentLowMean_fps"], 50);
  EXPECT_EQ(values["stutters"], 0);
  EXPECT_EQ(values["worstOfFirst5s_ms"], 20);
}

// Everything unknown in one frame and another of which the total is: neither spoils the rest.
TEST(RunMetrics, LeaveOutWhatIsUnknown) {
  RunFrames run = wholeRun();
  const MetricValues before = metricsOf(run);
  Frame unknown = run.frames[3];
  unknown.total_ms = kUnknown;
  unknown.live = 0;
  unknown.gather_ms = unknown.simulation_ms = 1e6;
  run.frames.insert(run.frames.begin() + 4, unknown);
  EXPECT_EQ(metricsOf(run), before);
  Frame partly = run.frames[3];
  partly.simulation_ms = partly.draw_ms = partly.wait_ms = partly.gl_ms = partly.latency_ms = kUnknown;
  partly.staged = true;
  partly.stages_ms = {float(kUnknown)};
  run.frames.push_back(partly);
  MetricValues values = metricsOf(run);
  EXPECT_EQ(namesOf(values), namesOf(before));
  for (const char* name : {"tick_ms.mean", "draw_ms.mean", "wait_ms.mean", "latency_ms.p99", "upkeep_ms.mean"}) {
    EXPECT_EQ(values[name], before.at(name)) << name;
  }
}

// On cuda a tick that is timed by stages is another graph: what it took is no figure of the game.
TEST(RunMetrics, TotalsLeaveOutWhatTimersDisturb) {
  RunFrames run = wholeRun();
  const MetricValues before = metricsOf(run);
  Frame timed = run.frames[3];
  timed.total_ms = timed.simulation_ms = timed.draw_ms = timed.latency_ms = 1e6;
  timed.live = 0;
  timed.staged = timed.disturbed = true;
  timed.stages_ms = {1, 3, 5};
  run.frames.push_back(timed);
  MetricValues values = metricsOf(run);
  EXPECT_NE(values["upkeep_ms.mean"], before.at("upkeep_ms.mean")) << "its stages count";
  for (const char* name : {"upkeep_ms.mean", "think_ms.mean", "upkeepAndGathering_ms.mean"}) {
    values[name] = before.at(name);
  }
  values["worstOfFirst5s_ms"] = before.at("worstOfFirst5s_ms");
  EXPECT_EQ(values, before);
}

TEST(RunMetrics, OfTicksAloneHaveNoPictures) {
  RunFrames run = wholeRun();
  run.drawn = false;
  const std::set<std::string> names = namesOf(metricsOf(run));
  for (const char* none : {"draw_ms.mean", "wait_ms.mean", "gl_ms.mean", "latency_ms.p50", "latency_ms.p99"}) {
    EXPECT_FALSE(names.contains(none)) << none;
  }
  EXPECT_EQ(names.size(), metrics().size() - 5);
}

TEST(RunMetrics, OfShadowsAreUpkeepAndGathering) {
  RunFrames run = wholeRun();
  run.shadow = true;
  for (Frame& frame : run.frames) frame.total_ms = kUnknown;
  MetricValues values = metricsOf(run);
  EXPECT_EQ(namesOf(values), (std::set<std::string>{"upkeep_ms.mean", "gathering_ms.mean", "upkeepAndGathering_ms.mean",
                                                    "candidatesPerEntity", "neighboursPerEntity"}));
  EXPECT_DOUBLE_EQ(values["upkeepAndGathering_ms.mean"], 6.5);
}

// Real time: frames with no tick, with one, and with five that catch up.
TEST(RunMetrics, OfPacedRunsCountTicksByTicks) {
  RunFrames run = runOf({5, 5, 5, 45});
  for (size_t i = 0; i < 4; ++i) run.frames[i].ticks = std::vector<uint32_t>{0, 1, 0, 5}[i];
  for (size_t i = 0; i < 4; ++i) run.frames[i].simulation_ms = std::vector<double>{0, 2, 0, 40}[i];
  MetricValues values = metricsOf(run);
  EXPECT_DOUBLE_EQ(values["ticksPerFrame.mean"], 1.5);
  EXPECT_DOUBLE_EQ(values["ticksPerFrame.most"], 5);
  EXPECT_DOUBLE_EQ(values["tick_ms.mean"], 7);
  EXPECT_DOUBLE_EQ(values["tick_ms.p50"], 8);
  EXPECT_DOUBLE_EQ(values["tick_ms.longest"], 8);
  EXPECT_DOUBLE_EQ(values["ticksPerSecond"], 1000.0 / 7);
  EXPECT_DOUBLE_EQ(values["meanFps"], 1000.0 / 15);
  for (Frame& frame : run.frames) frame.ticks = 0;
  values = metricsOf(run);
  EXPECT_EQ(values["ticksPerFrame.mean"], 0);
  EXPECT_FALSE(values.contains("tick_ms.mean"));
  EXPECT_FALSE(values.contains("ticksPerSecond"));
}

TEST(RunMetrics, LookAtFramesThatBeginInTheFirstFiveSeconds) {
  EXPECT_EQ(metricsOf(runOf({4999, 30, 40})).at("worstOfFirst5s_ms"), 4999);
  EXPECT_EQ(metricsOf(runOf({10, 4989, 7000, 8000})).at("worstOfFirst5s_ms"), 7000);
  EXPECT_EQ(metricsOf(runOf({10, 4990, 7000, 8000})).at("worstOfFirst5s_ms"), 4990);
}

TEST(RunMetrics, NeedTheStageTheyAreNamedAfter) {
  RunFrames run = wholeRun();
  run.stages = {"logic", "something", "think"};
  MetricValues values = metricsOf(run);
  EXPECT_FALSE(values.contains("upkeep_ms.mean"));
  EXPECT_FALSE(values.contains("upkeepAndGathering_ms.mean"));
  EXPECT_DOUBLE_EQ(values["think_ms.mean"], 2.5);
  EXPECT_DOUBLE_EQ(values["gathering_ms.mean"], 5);
}

// ---------------------------------------------------------------- stutters

TEST(Stutters, AreTwiceAndFourMillisecondsMore) {
  const auto with = [](double usual_ms, double one_ms) {
    std::vector<double> times_ms(200, usual_ms);
    times_ms[80] = one_ms;
    return stutters(times_ms);
  };
  EXPECT_EQ(with(10, 20), 0u);
  EXPECT_EQ(with(10, 20.1), 1u);
  EXPECT_EQ(with(1, 4.9), 0u);
  EXPECT_EQ(with(1, 5), 1u);
}

TEST(Stutters, AreSeenAtBothEnds) {
  std::vector<double> times_ms(200, 10.0);
  times_ms.front() = times_ms.back() = 50;
  EXPECT_EQ(stutters(times_ms), 2u);
  EXPECT_EQ(stutters(std::vector<double>{50, 10, 10}), 1u);
  EXPECT_EQ(stutters(std::vector<double>{50}), 0u);
  EXPECT_EQ(stutters({}), 0u);
}

// A game that becomes slow for long is slow, it does not stutter: only the sixty around count.
TEST(Stutters, AreNoSlowStretches) {
  std::vector<double> times_ms(400, 10.0);
  std::fill(times_ms.begin() + 200, times_ms.end(), 30.0);
  EXPECT_EQ(stutters(times_ms), 0u);
  std::fill(times_ms.begin() + 220, times_ms.end(), 10.0);
  EXPECT_EQ(stutters(times_ms), 20u);
}

// The definition again, for every frame by its own.
TEST(Stutters, AreThoseOfANaiveCount) {
  Noise noise(21);
  uint64_t all = 0;
  for (const size_t size : {2u, 30u, 61u, 62u, 300u}) {
    std::vector<double> times_ms(size);
    for (double& time_ms : times_ms) time_ms = 8 * noise.share() + (noise.share() < 0.2 ? 10 * noise.share() : 0);
    uint64_t expected = 0;
    for (size_t i = 0; i < size; ++i) {
      size_t first = i < 30 ? 0 : i - 30;
      while (first > 0 && first + 61 > size) --first;
      std::vector<double> others;
      for (size_t j = first; j < std::min(size, first + 61); ++j) {
        if (j != i) others.push_back(times_ms[j]);
      }
      std::sort(others.begin(), others.end());
      const double usual = (others[(others.size() - 1) / 2] + others[others.size() / 2]) / 2;
      expected += times_ms[i] > 2 * usual && times_ms[i] >= usual + 4;
    }
    EXPECT_EQ(stutters(times_ms), expected) << size;
    all += expected;
  }
  EXPECT_GT(all, 20u);
}

}  // namespace
}  // namespace gw::profile::test
