// Times per stage, and the captured sequence of launches.
#include "gpu/exec/stage_timer.h"

#include <gtest/gtest.h>

#include <thread>

#include "gpu/exec/tick_graph.h"
#include "gpu/math/state_hash.h"
#include "tests/gpu/probes.h"
#include "tests/gpu/random_cells.h"

namespace gw::cpu {
namespace {

TEST(StageTimer, RunsButDoesNotTimeWhenOff) {
  Queue queue({1});
  StageTimer timer;
  int runs = 0;
  timer.time(queue, "think", [&] { ++runs; });
  EXPECT_EQ(runs, 1);
  EXPECT_TRUE(timer.stages().empty());
}

TEST(StageTimer, AddsUpByNameInTheOrderOfFirstRuns) {
  Queue queue({1});
  StageTimer timer;
  timer.enable(true);
  std::string trace;
  for (int tick = 0; tick < 3; ++tick) {
    timer.time(queue, "spawn", [&] { trace += 's'; });
    timer.time(queue, "maintain", [&] { trace += 'm'; });
  }
  const std::string later = "spawn";  // the same name at another address
  timer.time(queue, later.c_str(), [&] { trace += 's'; });
  EXPECT_EQ(trace, "smsmsms");
  ASSERT_EQ(timer.stages().size(), 2u);
  EXPECT_EQ(timer.stages()[0].name, "spawn");
  EXPECT_EQ(timer.stages()[0].calls, 4u);
  EXPECT_EQ(timer.stages()[1].name, "maintain");
  EXPECT_EQ(timer.stages()[1].calls, 3u);
}

TEST(StageTimer, MeasuresWhatAStageTakes) {
  Queue queue({1});
  StageTimer timer;
  timer.enable(true);
  for (int i = 0; i < 3; ++i) {
    timer.time(queue, "slow", [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); });
    timer.time(queue, "fast", [] {});
  }
  EXPECT_GE(timer.stages()[0].total_ms, 15.0);
  EXPECT_GE(timer.stages()[1].total_ms, 0.0);
  EXPECT_LT(timer.stages()[1].total_ms, timer.stages()[0].total_ms);
}

TEST(StageTimer, StopsWhenSwitchedOff) {
  Queue queue({1});
  StageTimer timer;
  timer.enable(true);
  timer.time(queue, "hash", [] {});
  timer.enable(false);
  timer.time(queue, "hash", [] {});
  EXPECT_EQ(timer.stages()[0].calls, 1u);
}

TEST(TickGraph, ReplaysItsLaunchesInOrder) {
  const test::Words start = test::makeWords(1000, 1);
  test::Words expected = start;
  const auto mixOnce = [](const test::Words& in) {
    test::Words out;
    for (size_t i = 0; i < in.size(); ++i) out.push_back(mixed(in[i] + 3 * in[(i + 1) % in.size()]));
    return out;
  };
  const test::Probes device = probes();
  for (uint32_t ticks = 0; ticks <= 5; ++ticks) {
    EXPECT_EQ(device.replayGraph({2}, start, ticks), expected) << ticks;
    for (int launch = 0; launch < 3; ++launch) expected = mixOnce(expected);
  }
}

TEST(TickGraph, MovesWithItsLaunches) {
  Queue queue({1});
  int runs = 0;
  TickGraph first(queue, [&] { ++runs; });
  const int atCapture = runs;
  TickGraph second(std::move(first));
  TickGraph third;
  third = std::move(second);
  third.replay(queue);
  third.replay(queue);
  EXPECT_EQ(runs - atCapture, 2);
}

}  // namespace
}  // namespace gw::cpu
