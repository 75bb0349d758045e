// Two sessions: what is slower, what is noise, and what says nothing.
#include "game/profile/metrics/baseline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "tests/game/profile/metrics/noise.h"

namespace gw::profile::test {
namespace {

MetricValues runAt(double factor) {
  return {{"meanFps", 60 / factor},
          {"frame_ms.mean", 16 * factor},
          {"frame_ms.p99", 20 * factor},
          {"upkeepAndGathering_ms.mean", 3 * factor},
          {"draw_ms.mean", 2.0},
          {"liveEntities.mean", 500 * factor},
          {"stutters", 0.0}};
}

// Of one contender, whose runs are by `factor` slower and scatter by `noise`.
Contender contenderOf(const std::string& name, uint64_t seed, double factor, double noise, int runs) {
  Noise scatter(seed);
  Contender contender;
  contender.name = name;
  contender.hash = "0123456789abcdef";
  for (int run = 0; run < runs; ++run) contender.runs.push_back(runAt(factor * scatter.normal(1, noise)));
  return contender;
}

Report sessionOf(uint64_t seed, double factor = 1, double noise = 0.01, int runs = 10) {
  Report report;
  report.machine.cpu = "A processor";
  report.machine.commit = "abc";
  report.setup.scene = "swarm";
  report.setup.drawn = "offscreen 1280x720";
  report.setup.ticks = 1800;
  Case one;
  one.enemies = 4096;
  one.contenders.push_back(contenderOf("ngrid", 2 * seed, factor, noise, runs));
  one.contenders.push_back(contenderOf("uniform", 2 * seed + 1, factor, noise, runs));
  report.cases.push_back(one);
  return report;
}

const Compared& rowOf(const Comparison& comparison, std::string_view metric, std::string_view contender = "ngrid") {
  const auto found = std::find_if(comparison.compared.begin(), comparison.compared.end(), [&](const Compared& one) {
    return one.metric == metric && one.contender == contender;
  });
  if (found == comparison.compared.end()) throw std::runtime_error("nothing compared of " + std::string(metric));
  return *found;
}

bool says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& s) { return s.find(part) != std::string::npos; });
}

TEST(Baseline, EqualSessionsPass) {
  int passed = 0, rows = 0, slower = 0;
  for (uint64_t trial = 0; trial < 100; ++trial) {
    const Comparison comparison = compareWithBaseline(sessionOf(2 * trial), sessionOf(2 * trial + 1));
    passed += comparison.gate == Gate::passed;
    for (const Compared& one : comparison.compared) {
      if (one.metric != "frame_ms.mean") continue;  // what else is measured moves with it here
      ++rows;
      slower += one.verdict == Verdict::slower;
    }
  }
  EXPECT_GE(passed, 95);
  EXPECT_EQ(rows, 200);
  EXPECT_LE(slower, 10);
}

TEST(Baseline, FivePercentSlowerIsSlower) {
  int failed = 0;
  for (uint64_t trial = 0; trial < 20; ++trial) {
    const Comparison comparison = compareWithBaseline(sessionOf(2 * trial, 1.05), sessionOf(2 * trial + 1));
    failed += comparison.gate == Gate::slower;
    EXPECT_EQ(rowOf(comparison, "frame_ms.p99").verdict, Verdict::slower);
    EXPECT_EQ(rowOf(comparison, "meanFps").verdict, Verdict::slower);
    EXPECT_NEAR(rowOf(comparison, "frame_ms.p99").ratio.value, 1.05, 0.02);
    EXPECT_NEAR(rowOf(comparison, "meanFps").ratio.value, 1 / 1.05, 0.02);
    EXPECT_TRUE(rowOf(comparison, "frame_ms.p99").failsGate);
    EXPECT_FALSE(rowOf(comparison, "frame_ms.mean").failsGate);  // slower, but not gated
  }
  EXPECT_EQ(failed, 20);
}

TEST(Baseline, FasterIsFasterAndPasses) {
  const Comparison comparison = compareWithBaseline(sessionOf(1, 0.9), sessionOf(2));
  EXPECT_EQ(rowOf(comparison, "frame_ms.p99").verdict, Verdict::faster);
  EXPECT_EQ(rowOf(comparison, "meanFps").verdict, Verdict::faster);
  EXPECT_EQ(comparison.gate, Gate::passed);
}

// The interval excludes 1, but one run differs from the next by more than the sessions do.
TEST(Baseline, ChangesWithinTheSpreadOfRunsAreNoise) {
  const Comparison comparison = compareWithBaseline(sessionOf(1, 1.03, 0.04, 100), sessionOf(2, 1, 0.04, 100));
  const Compared& row = rowOf(comparison, "frame_ms.mean");
  EXPECT_GT(row.ratio.low, 1);
  EXPECT_EQ(row.verdict, Verdict::same);
  EXPECT_EQ(comparison.gate, Gate::passed);
  // Either session may be the one that scatters.
  for (const double ofNow : {0.001, 0.04}) {
    const Report now = sessionOf(1, 1.03, ofNow, 100), old = sessionOf(2, 1, 0.041 - ofNow, 100);
    EXPECT_EQ(rowOf(compareWithBaseline(now, old), "frame_ms.mean").verdict, Verdict::same) << ofNow;
  }
  EXPECT_EQ(
      rowOf(compareWithBaseline(sessionOf(1, 1.06, 0.04, 100), sessionOf(2, 1, 0.04, 100)), "frame_ms.mean").verdict,
      Verdict::slower);
}

TEST(Baseline, ChangesBelowOnePercentAreNotSaid) {
  EXPECT_EQ(rowOf(compareWithBaseline(sessionOf(1, 1.008, 0.0001), sessionOf(2, 1, 0.0001)), "frame_ms.mean").verdict,
            Verdict::same);
  EXPECT_EQ(rowOf(compareWithBaseline(sessionOf(1, 1.012, 0.0001), sessionOf(2, 1, 0.0001)), "frame_ms.mean").verdict,
            Verdict::slower);
}

TEST(Baseline, OnlyMetricsWithADirectionAreCompared) {
  const Comparison comparison = compareWithBaseline(sessionOf(1), sessionOf(2));
  EXPECT_THROW(rowOf(comparison, "liveEntities.mean"), std::runtime_error);
  EXPECT_EQ(comparison.compared.size(), 2u * 6);
  EXPECT_EQ(
      std::count_if(comparison.compared.begin(), comparison.compared.end(), [](const Compared& c) { return c.gated; }),
      2 * 3);
}

TEST(Baseline, WithoutPicturesTheRateIsOfTicks) {
  Report now = sessionOf(1), old = sessionOf(2);
  for (Report* report : {&now, &old}) {
    for (Contender& contender : report->cases[0].contenders) {
      for (MetricValues& run : contender.runs) {
        run.erase("draw_ms.mean");
        run["ticksPerSecond"] = 2 * run["meanFps"];
      }
    }
  }
  const Comparison comparison = compareWithBaseline(now, old);
  EXPECT_TRUE(rowOf(comparison, "ticksPerSecond").gated);
  EXPECT_FALSE(rowOf(comparison, "meanFps").gated);
}

// None before and some now has no ratio, and is still slower; rarely is not.
TEST(Baseline, CountsMayBeZero) {
  Report now = sessionOf(1), old = sessionOf(2);
  EXPECT_EQ(rowOf(compareWithBaseline(now, old), "stutters").verdict, Verdict::same);
  auto& runs = now.cases[0].contenders[0].runs;
  runs[3]["stutters"] = 2;
  EXPECT_EQ(rowOf(compareWithBaseline(now, old), "stutters").verdict, Verdict::same);
  for (size_t i = 0; i < runs.size(); ++i) runs[i]["stutters"] = 3 + double(i % 3);
  EXPECT_EQ(rowOf(compareWithBaseline(now, old), "stutters").verdict, Verdict::slower);
  EXPECT_EQ(rowOf(compareWithBaseline(old, now), "stutters").verdict, Verdict::faster);
}

TEST(Baseline, FewRunsAreNotJudged) {
  const Comparison comparison = compareWithBaseline(sessionOf(1, 2, 0.01, 9), sessionOf(2));
  EXPECT_EQ(rowOf(comparison, "frame_ms.p99").verdict, Verdict::tooFewRuns);
  EXPECT_NEAR(rowOf(comparison, "frame_ms.p99").ratio.value, 2, 0.1);
  EXPECT_EQ(comparison.gate, Gate::cannotJudge);
  EXPECT_NE(comparison.gateSentence.find("10 runs"), std::string::npos);
}

TEST(Baseline, WhatIsGoneIsNoPass) {
  Report now = sessionOf(1);
  now.cases[0].contenders.pop_back();
  Comparison comparison = compareWithBaseline(now, sessionOf(2));
  EXPECT_EQ(rowOf(comparison, "meanFps", "uniform").verdict, Verdict::missing);
  EXPECT_EQ(comparison.gate, Gate::cannotJudge);
  EXPECT_NE(baselineText(comparison).find("uniform: only in the old session"), std::string::npos);
  now = sessionOf(1);
  now.cases.clear();
  EXPECT_EQ(compareWithBaseline(now, sessionOf(2)).gate, Gate::cannotJudge);
  EXPECT_EQ(compareWithBaseline(now, now).gate, Gate::cannotJudge);
}

TEST(Baseline, WhatIsNewDisturbsNoGate) {
  Report old = sessionOf(2);
  old.cases[0].contenders.pop_back();
  Comparison comparison = compareWithBaseline(sessionOf(1), old);
  EXPECT_EQ(rowOf(comparison, "meanFps", "uniform").verdict, Verdict::missing);
  EXPECT_EQ(comparison.gate, Gate::passed);
  EXPECT_NE(baselineText(comparison).find("uniform: only in the new session"), std::string::npos);
  Report more = sessionOf(1);
  more.cases.push_back(sessionOf(9, 3).cases[0]);
  more.cases[1].enemies = 8192;
  EXPECT_EQ(compareWithBaseline(more, sessionOf(2)).gate, Gate::passed);
  EXPECT_EQ(compareWithBaseline(more, sessionOf(2)).compared.size(), 4u * 6);
}

// A slow case among many equal ones is found, and its slowness is not lost in their number.
TEST(Baseline, FindsOneSlowCaseAmongMany) {
  Report now = sessionOf(1), old = sessionOf(2);
  for (uint32_t i = 1; i < 8; ++i) {
    now.cases.push_back(sessionOf(10 + 2 * i, i == 5 ? 1.05 : 1).cases[0]);
    old.cases.push_back(sessionOf(11 + 2 * i).cases[0]);
    now.cases[i].enemies = old.cases[i].enemies = 4096 + i;
  }
  const Comparison comparison = compareWithBaseline(now, old);
  EXPECT_EQ(comparison.gate, Gate::slower);
  for (const Compared& one : comparison.compared) {
    EXPECT_EQ(one.failsGate, one.gated && one.enemies == 4101) << one.enemies << " " << one.metric;
  }
}

// ---------------------------------------------------------------- what differs

TEST(Baseline, RefusesAnotherMeasurement) {
  const Report old = sessionOf(1);
  const auto refuses = [&](auto change, const char* part) {
    Report now = sessionOf(2);
    change(now);
    const Comparison comparison = compareWithBaseline(now, old);
    EXPECT_NE(comparison.error.find(part), std::string::npos) << comparison.error;
    EXPECT_TRUE(comparison.compared.empty());
    EXPECT_EQ(comparison.gate, Gate::cannotJudge);
    EXPECT_EQ(baselineText(comparison), comparison.error + "\n");
  };
  refuses([](Report& r) { r.setup.scene = "arcade"; }, "the scene was \"swarm\" and is \"arcade\"");
  refuses([](Report& r) { r.setup.mode = "deadline"; }, "the mode was unknown");
  refuses([](Report& r) { r.setup.drawn = "offscreen 640x360"; }, "\"offscreen 640x360\"");
  refuses([](Report& r) { r.setup.pacing = "real time"; }, "the pacing");
  refuses([](Report& r) { r.setup.ticks = 600; }, "the number of ticks was \"1800\" and is \"600\"");
  refuses([](Report& r) { r.setup.warmUp = 60; }, "the warm-up");
}

TEST(Baseline, OfAnotherMachineIsShownButNotJudged) {
  const Report old = sessionOf(1);
  const auto cannot = [&](auto change, const char* part) {
    Report now = sessionOf(2, 2);
    change(now);
    const Comparison comparison = compareWithBaseline(now, old);
    EXPECT_EQ(comparison.error, "");
    EXPECT_TRUE(says(comparison.differences, part));
    EXPECT_EQ(rowOf(comparison, "meanFps").verdict, Verdict::slower);
    EXPECT_EQ(comparison.gate, Gate::cannotJudge);
    EXPECT_NE(baselineText(comparison).find("Gate: cannot judge"), std::string::npos);
  };
  cannot([](Report& r) { r.machine.cpu = "Another"; }, "Another processor: it was \"A processor\" and is \"Another\".");
  cannot([](Report& r) { r.machine.cores = "2"; }, "number of cores");
  cannot([](Report& r) { r.machine.gpu = "G"; }, "Another GPU: it was unknown");
  cannot([](Report& r) { r.machine.driver = "D"; }, "driver");
  cannot([](Report& r) { r.machine.renderer = "R"; }, "renderer");
  cannot([](Report& r) { r.machine.system = "S"; }, "system");
  cannot([](Report& r) { r.setup.device = "cpu, 1 thread"; }, "device");
}

TEST(Baseline, UnderOtherConditionsOfTheProcessorsIsShownButNotJudged) {
  const ProcessorState usual{"0-7", 4, 0, "performance", "off", "2400 MHz"};
  const auto with = [&](uint64_t seed, const ProcessorState& state) {
    Report report = sessionOf(seed);
    report.machine.processors = state;
    return report;
  };
  const auto compared = [&](const ProcessorState& old, const ProcessorState& now) {
    return compareWithBaseline(with(1, now), with(2, old));
  };
  EXPECT_EQ(compared(usual, usual).gate, Gate::passed);
  EXPECT_TRUE(compared(usual, usual).differences.empty());
  const auto cannot = [&](auto change, const char* part) {
    ProcessorState other = usual;
    change(other);
    for (const Comparison& comparison : {compared(usual, other), compared(other, usual)}) {
      EXPECT_EQ(comparison.error, "");
      ASSERT_EQ(comparison.differences.size(), 1u) << part;
      EXPECT_EQ(comparison.gate, Gate::cannotJudge) << part;
      EXPECT_TRUE(
          baselineText(comparison)
              .ends_with(
                  "Gate: cannot judge, because a quota held threads up, or affinity, quota or clocks are others.\n"));
    }
    EXPECT_TRUE(says(compared(usual, other).differences, part)) << part;
  };
  cannot([](ProcessorState& s) { s.allowed = "0"; }, "Another set of allowed processors: it was \"0-7\" and is \"0\".");
  cannot([](ProcessorState& s) { s.quota = kUnknown; },
         "Another quota of the processors' time: it was \"4.00\" and is \"none\".");
  cannot([](ProcessorState& s) { s.governor = "powersave"; },
         "Another governor: it was \"performance\" and is \"powersave\".");
  cannot([](ProcessorState& s) { s.turbo = ""; }, "Another setting of turbo: it was \"off\" and is unknown.");
  cannot([](ProcessorState& s) { s.clockRange = "800 to 2400 MHz"; }, "Another range of clocks");
  cannot([](ProcessorState& s) { s.throttled_s = 5.6; }, "held the new session up for 5.60 s.");

  // Equal quotas that held both up: either may have been held up where it mattered.
  ProcessorState held = usual;
  held.throttled_s = 0.2;
  EXPECT_EQ(compared(held, held).gate, Gate::cannotJudge);
  EXPECT_EQ(compared(held, held).differences.size(), 2u);
  // A report of an earlier program says nothing of it, and is judged as it was.
  EXPECT_EQ(compareWithBaseline(with(1, usual), sessionOf(2)).gate, Gate::passed);
}

TEST(Baseline, OfAnotherBuildIsSaidAndJudged) {
  const Report old = sessionOf(1);
  const auto judges = [&](auto change, const char* part) {
    Report now = sessionOf(2);
    change(now);
    const Comparison comparison = compareWithBaseline(now, old);
    EXPECT_EQ(comparison.differences.size(), part ? 1u : 0u);
    EXPECT_TRUE(!part || says(comparison.differences, part));
    EXPECT_EQ(comparison.gate, Gate::passed);
  };
  judges([](Report&) {}, nullptr);
  judges([](Report& r) { r.machine.compiler = "another"; }, "compiler");
  judges([](Report& r) { r.machine.flags = "-O1"; }, "flags");
  judges([](Report& r) { r.machine.commit = "def"; }, "commit");
  judges([](Report& r) { r.setup.interrupted = true; }, "The new session was interrupted");
  judges([](Report& r) { r.cases[0].contenders[0].hash = "fedcba9876543210"; },
         "ngrid with 4096 enemies ends in another");
  judges([](Report& r) { r.cases[0].contenders[0].hash = ""; }, nullptr);
}

TEST(BaselineText, HasARowForEachFigureAndEndsWithTheGate) {
  const std::string text = baselineText(compareWithBaseline(sessionOf(1, 1.1), sessionOf(2)));
  EXPECT_NE(text.find("4096 enemies, ngrid\n"), std::string::npos);
  EXPECT_NE(text.find("* meanFps"), std::string::npos);
  EXPECT_NE(text.find("  frame_ms.mean"), std::string::npos);
  EXPECT_NE(text.find("slower, fails the gate"), std::string::npos);
  EXPECT_TRUE(text.ends_with("Gate: failed, 6 of 6 gated figures slower beyond noise.\n"));
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace gw::profile::test
