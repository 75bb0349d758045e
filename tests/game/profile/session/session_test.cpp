// Whole sessions on the processor, without a picture: what is compared with what, and what an end in between leaves.
#include "game/profile/session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/platform/user_error.h"

namespace gw::profile {
namespace {

constexpr uint32_t kTicks = 120;

SessionPlan planOf(const std::string& contenders, uint32_t runs) {
  SessionPlan plan;
  plan.scene = SceneKind::ramp;
  plan.enemies = {64};
  plan.ticks = kTicks;
  plan.runs = runs;
  plan.contenders = parseContenders(contenders);
  plan.drawn = Drawn::nothing;
  return plan;
}

// A session, and all that it told on its way.
struct Told {
  std::vector<SessionProgress> progress;
  std::vector<std::string> runs;  // that are over: "grid 1"
  std::vector<Setup> setups;

  // `goOn` is asked at every step.
  Report of(SessionPlan plan, const std::function<bool(const SessionProgress&)>& goOn) {
    SimulationConfig computing;
    computing.threads = 1;
    Session session(std::move(plan), computing, GW_ASSETS_DIR, cpu::makeSimulation);
    return session.run([&](const Setup& setup) { setups.push_back(setup); },
                       [&](uint32_t, const ContenderChoice& contender, uint32_t run, const RunFrames&) {
                         runs.push_back(contender.name + " " + std::to_string(run));
                       },
                       [&](const SessionProgress& now) {
                         progress.push_back(now);
                         return goOn(now);
                       });
  }
  Report of(SessionPlan plan) {
    return of(std::move(plan), [](const SessionProgress&) { return true; });
  }
};

// Ends a session in the midst of this run of this contender.
std::function<bool(const SessionProgress&)> endIn(const std::string& run, const std::string& contender) {
  return [=](const SessionProgress& now) {
    const bool there = now.doing.find("run " + run + " ") != std::string::npos && now.doing.ends_with(", " + contender);
    return !there || now.tick < kTicks / 2;
  };
}

bool warns(const Report& report, const std::string& words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

TEST(Session, RunsTakeTurnsAndEndAlike) {
  Told told;
  const Report report = told.of(planOf("ngrid,grid,thesis", 2));
  EXPECT_EQ(told.runs, (std::vector<std::string>{"ngrid 1", "grid 1", "thesis 1", "ngrid 2", "grid 2", "thesis 2"}));
  ASSERT_EQ(report.cases.size(), 1u);
  const Case& played = report.cases[0];
  EXPECT_EQ(played.enemies, 64u);
  ASSERT_EQ(played.contenders.size(), 3u);
  EXPECT_EQ(played.contenders[0].hash.size(), 16u);
  EXPECT_EQ(played.contenders[0].hash, played.contenders[1].hash);
  EXPECT_TRUE(played.contenders[2].shadow && played.contenders[2].hash.empty());
  ASSERT_EQ(played.speedUps.size(), 2u);
  EXPECT_GT(played.speedUps[0].tick.value, 0);
  EXPECT_GT(played.speedUps[1].upkeepAndGathering.value, 0);
  EXPECT_TRUE(std::isnan(played.speedUps[1].tick.value)) << "a shadow has no ticks of its own";
  EXPECT_TRUE(warns(report, "2 runs are too few for intervals"));
  EXPECT_FALSE(report.setup.interrupted);
}

TEST(Session, SaysWhatItMeasuresBeforeItDoes) {
  Told told;
  const Report report = told.of(planOf("ngrid", 1));
  ASSERT_EQ(told.setups.size(), 1u);
  for (const profile::Setup& setup : {told.setups[0], report.setup}) {
    EXPECT_EQ(setup.scene, "ramp");
    EXPECT_EQ(setup.mode, "practice");
    EXPECT_EQ(setup.device, "cpu, 1 thread");
    EXPECT_EQ(setup.drawn, "nothing: simulation only");
    EXPECT_EQ(setup.ticks, kTicks);
    EXPECT_EQ(setup.warmUp, kTicks / 4);
    EXPECT_EQ(setup.runs, 1u);
  }
  EXPECT_FALSE(report.machine.cpu.empty());
  EXPECT_NE(report.machine.flags.find("-ffp-contract=off"), std::string::npos) << report.machine.flags;
  EXPECT_EQ(report.machine.flags.find("-W"), std::string::npos) << report.machine.flags;
}

TEST(Session, CanBeRefusedBeforeAnythingIsMeasured) {
  SimulationConfig computing;
  Session session(planOf("ngrid", 1), computing, GW_ASSETS_DIR, cpu::makeSimulation);
  bool measured = false;
  EXPECT_THROW(session.run([](const profile::Setup&) { throw UserError(ExitCode::badFile, "another"); },
                           [&](auto&&...) { measured = true; }, [](const SessionProgress&) { return true; }),
               UserError);
  EXPECT_FALSE(measured);
}

TEST(Session, KnowsTheTimeLeft) {
  Told told;
  told.of(planOf("ngrid,grid", 3));
  std::vector<double> left_s;
  for (const SessionProgress& now : told.progress) {
    if (now.doing.find("run ") != std::string::npos && std::isfinite(now.left_s)) left_s.push_back(now.left_s);
  }
  ASSERT_FALSE(left_s.empty());
  EXPECT_DOUBLE_EQ(left_s.back(), 0);
  EXPECT_GT(left_s.front(), 0);
  const auto recording = std::find_if(told.progress.begin(), told.progress.end(), [](const SessionProgress& now) {
    return now.doing == "recording ramp with 64 enemies" && now.left_s > 0;
  });
  EXPECT_NE(recording, told.progress.end()) << "of the recording too";
}

TEST(Session, NobodyIsComparedWithARunThatWasCut) {
  for (const char* cut : {"ngrid", "grid"}) {
    Told told;
    const Report report = told.of(planOf("ngrid,grid", 2), endIn("1", cut));
    EXPECT_TRUE(report.setup.interrupted);
    const bool first = std::string(cut) == "ngrid";
    ASSERT_EQ(report.cases.at(0).contenders.size(), first ? 1u : 2u) << cut;
    EXPECT_FALSE(report.cases[0].contenders.back().runs.empty()) << "its figures are told";
    for (const SpeedUp& speedUp : report.cases[0].speedUps) EXPECT_TRUE(std::isnan(speedUp.tick.value));
    EXPECT_EQ(warns(report, "grid at 64 enemies is not compared"), !first);
    EXPECT_TRUE(warns(report, first ? "Interrupted after 1 run:" : "Interrupted after 2 runs:"));
  }
}

TEST(Session, ACutRunIsLeftOutWhereThereAreOthers) {
  Told told;
  const Report report = told.of(planOf("ngrid,grid", 3), endIn("2", "grid"));
  const Case& played = report.cases.at(0);
  EXPECT_EQ(played.contenders.at(0).runs.size(), 2u);
  EXPECT_EQ(played.contenders.at(1).runs.size(), 1u);
  EXPECT_GT(played.speedUps.at(0).tick.value, 0);
  EXPECT_TRUE(warns(report, "Interrupted after 3 runs:"));
}

TEST(Session, WithoutAFrameThereIsNoReport) {
  Told told;
  try {
    told.of(planOf("ngrid", 1), [](const SessionProgress& now) { return now.tick < 10; });
    ADD_FAILURE() << "a report of nothing";
  } catch (const UserError& error) {
    EXPECT_EQ(error.code, ExitCode::failedRun);
    EXPECT_NE(std::string(error.what()).find("before a single frame"), std::string::npos);
  }
}

TEST(Machine, ReadsTheGpuThatPlays) {
  const std::string lines =
      "NVIDIA T4, 580.65, 585, 27.51, 41\n"
      "NVIDIA H200, 580.65, 1980, [N/A], 33\n";
  const auto second = gpuStateIn(lines, "cuda, NVIDIA H200");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->name, "NVIDIA H200");
  EXPECT_EQ(second->driver, "580.65");
  EXPECT_EQ(second->clock_MHz, 1980);
  EXPECT_TRUE(std::isnan(second->power_W));
  EXPECT_EQ(second->temperature_C, 33);
  EXPECT_EQ(gpuStateIn(lines, "cpu, 2 threads")->name, "NVIDIA T4") << "the one that may draw";
  EXPECT_FALSE(gpuStateIn("No devices were found\n", "cuda"));
  EXPECT_FALSE(gpuStateIn("", "cuda"));
}

TEST(Machine, TellsTheMeanOfItsGpu) {
  Machine machine;
  tellGpu(machine, {});
  EXPECT_TRUE(machine.gpu.empty());
  tellGpu(machine, {{"T4", "1", 1000, 20, kUnknown}, {"T4", "1", 1200, kUnknown, kUnknown}});
  EXPECT_EQ(machine.gpu, "T4");
  EXPECT_EQ(machine.gpuClock_MHz, 1100);
  EXPECT_EQ(machine.gpuPower_W, 20);
  EXPECT_TRUE(std::isnan(machine.gpuTemperature_C));
}

TEST(Machine, CountsTheProcessorsThatItsTimesAreAbout) {
  std::istringstream stat("cpu  10 0 0 5\ncpu0 5 0 0 2\ncpu1 5 0 0 3\nintr 12\nctxt 3\n");
  EXPECT_EQ(processorsIn(stat), 2u);
}

TEST(Machine, OthersTakeAShare) {
  const MachineUse use;
  double sum = 0;
  for (int i = 0; i < 3000000; ++i) sum += std::sqrt(double(i));
  EXPECT_GT(sum, 0);
  const double share = use.othersShare();
  EXPECT_GE(share, 0);
  EXPECT_LE(share, 1);
}

}  // namespace
}  // namespace gw::profile
