// What a session plays, and what plays it.
#include "game/profile/session/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/profile/session/contender_choice.h"
#include "game/profile/session/refill.h"
#include "game/profile/session/runner.h"
#include "game/session/fixed_timestep.h"
#include "host/platform/user_error.h"

namespace gw::profile {
namespace {

constexpr uint32_t kFit = 300, kTicks = 240;

std::unique_ptr<Simulation> makeHere(const SimulationConfig& config) {
  SimulationConfig two = config;
  two.threads = 2;
  return cpu::makeSimulation(two);
}
const MakeSimulation kHere = makeHere;

Scene recorded(SceneKind kind, uint32_t ticks = kTicks) {
  return recordScene(kind, {kFit, ticks, 3}, readRuleTexts(GW_ASSETS_DIR), kHere, [](uint32_t) { return true; });
}

// The runs' reports, played from the recording alone.
std::vector<TickReport> played(const Scene& scene) {
  const auto game = makeHere(replayConfig(scene.replay));
  std::vector<TickReport> reports;
  for (const InputRecord& input : scene.replay.inputs) {
    game->tick(input);
    reports.push_back(game->report());
  }
  return reports;
}

uint32_t askedFor(uint16_t buttons) {
  return kPracticeCounts[buttons >> kSpawnCountShift & kSpawnCountMask];
}

TEST(Refill, AsksForWhatIsMissingAndForAllTypesByTurns) {
  Refill refill(7, 8192);
  std::vector<uint32_t> types;
  uint32_t live = 0, ticks = 0;
  for (; live < 8192; ++ticks) {
    ASSERT_LT(ticks, 100u);
    const uint16_t buttons = refill.buttons(live, 8192, false);
    ASSERT_EQ(buttons != 0, ticks % 2 == 0) << "the game takes presses";
    if (buttons == 0) continue;
    types.push_back(buttons >> kSpawnTypeShift & kSpawnTypeMask);
    live = std::min(8192u, live + askedFor(buttons));
  }
  for (uint32_t type = 0; type < 7; ++type) EXPECT_GE(std::count(types.begin(), types.end(), type), 1) << type;
}

TEST(Refill, MakesGoodEveryLossAtOnceUnlessItMustBeExact) {
  for (uint32_t missing = 1; missing < 40; ++missing) {
    EXPECT_GE(askedFor(Refill(7, 8192).buttons(8192 - missing, 8192, false)), missing);
    EXPECT_LE(askedFor(Refill(7, 8192).buttons(8192 - missing, 8192, true)), missing);
  }
  EXPECT_EQ(Refill(7, 8192).buttons(8192, 8192, false), 0);
  EXPECT_EQ(askedFor(Refill(7, 1).buttons(0, 1, false)), 1u);
  EXPECT_LE(askedFor(Refill(7, 1u << 20).buttons(0, 1u << 20, false)), 2000u);
}

TEST(Scene, KeepsTheFiveMinutesFull) {
  const Scene scene = recorded(SceneKind::fiveMinutes);
  ASSERT_EQ(scene.replay.ticks(), kTicks);
  const std::vector<TickReport> reports = played(scene);
  uint32_t since = 0, longest = 0;  // ticks since it was full
  for (uint32_t t = 0; t < kTicks; ++t) {
    ASSERT_EQ(reports[t].hash, scene.replay.hashes[t]) << "tick " << t + 1;
    since = reports[t].enemies >= kFit * 9 / 10 ? 0 : since + 1;
    if (t >= 60) longest = std::max(longest, since);
  }
  EXPECT_LE(longest, 8u) << "ticks to make good what a blast around the ship takes";
  EXPECT_EQ(reports.back().over, 0u);
  EXPECT_GT(reports.back().kills, 0u);
}

TEST(Scene, RampGrowsSteadily) {
  const std::vector<TickReport> reports = played(recorded(SceneKind::ramp, 600));
  for (const uint32_t share : {1u, 2u, 3u, 4u}) {
    const uint32_t live = reports[share * 150 - 1].enemies, wanted = kFit * share / 4;
    EXPECT_LE(live, wanted);
    EXPECT_GE(live + kFit / 5, wanted) << share;
  }
}

TEST(Scene, SwarmBeginsWithAllAndEndsWithTheRun) {
  const Scene scene = recorded(SceneKind::swarm, 36000);
  const std::vector<TickReport> reports = played(scene);
  EXPECT_EQ(reports.front().enemies, kFit);
  EXPECT_NE(reports.back().over, 0u);
  EXPECT_TRUE(scene.replay.result.over);
  EXPECT_LT(scene.replay.ticks(), 36000u);
}

TEST(Scene, RecordingEndsWhenSomebodyWants) {
  const Scene scene = recordScene(SceneKind::menu, {kFit, 500}, readRuleTexts(GW_ASSETS_DIR), kHere,
                                  [](uint32_t tick) { return tick < 7; });
  EXPECT_EQ(scene.replay.ticks(), 7u);
  EXPECT_TRUE(scene.title);
}

TEST(Scene, IsCutToItsFirstTicks) {
  Scene scene = recorded(SceneKind::menu, 150);
  const std::vector<uint64_t> hashes = scene.replay.hashes;
  cutTo(scene, 0);
  EXPECT_EQ(scene.replay.ticks(), 150u);
  cutTo(scene, 70);
  EXPECT_EQ(scene.replay.hashes, std::vector<uint64_t>(hashes.begin(), hashes.begin() + 70));
  EXPECT_EQ(scene.replay.fieldHashes.size(), 1u);
}

TEST(Scene, CommittedFiveMinutesPlayAsRecorded) {
  Scene scene = readFiveMinutes(GW_ASSETS_DIR);
  EXPECT_EQ(scene.replay.ticks(), 18000u);
  EXPECT_EQ(scene.replay.header.enemies, 8192u);
  cutTo(scene, 90);
  const std::vector<TickReport> reports = played(scene);
  for (uint32_t t = 0; t < 90; ++t) ASSERT_EQ(reports[t].hash, scene.replay.hashes[t]) << "tick " << t + 1;
  EXPECT_EQ(reports.back().enemies, 8192u);
}

TEST(Contenders, AreReadAndRefusedByName) {
  const auto chosen = parseContenders("ngrid,grid,grid-hashed,brute,thesis");
  ASSERT_EQ(chosen.size(), 5u);
  EXPECT_TRUE(chosen.back().shadow());
  EXPECT_FALSE(chosen.front().shadow());
  const auto refusal = [](const char* list) {
    try {
      parseContenders(list);
    } catch (const UserError& error) {
      EXPECT_EQ(error.code, ExitCode::badUsage);
      return std::string(error.what());
    }
    return std::string("taken");
  };
  EXPECT_NE(refusal("ngrid,octree").find("'octree', which is none of ngrid, grid"), std::string::npos);
  EXPECT_NE(refusal("grid,grid").find("grid twice"), std::string::npos);
  EXPECT_NE(refusal("thesis").find("name one of those first"), std::string::npos);
  EXPECT_NE(refusal("").find("names nothing"), std::string::npos);
  EXPECT_NE(refusal("ngrid,").find("taken"), std::string::npos) << "a comma at the end is no contender";
}

struct Runs {
  Scene scene = recorded(SceneKind::fiveMinutes);
  SimulationConfig config = replayConfig(scene.replay);
  Runner runner{scene, config, kHere, nullptr};
};

TEST(Runner, AllContendersPlayTheSameRun) {
  Runs of;
  for (const ContenderChoice& contender : contenderChoices()) {
    const PlayedRun run = of.runner.play(contender, {kTicks, 30}, [](const Frame&) { return true; });
    ASSERT_EQ(run.frames.frames.size(), kTicks) << contender.name;
    EXPECT_TRUE(run.whole);
    EXPECT_EQ(run.hash, of.scene.replay.hashes.back()) << contender.name;
    EXPECT_EQ(run.frames.shadow, contender.shadow());
    EXPECT_NE(std::find(run.frames.stages.begin(), run.frames.stages.end(), "maintain"), run.frames.stages.end());
    uint32_t warm = 0, staged = 0, counted = 0;
    for (const Frame& frame : run.frames.frames) {
      warm += frame.warmUp;
      staged += frame.staged;
      counted += frame.searching == frame.searching;
      EXPECT_TRUE(contender.shadow() || frame.total_ms > 0);
      EXPECT_EQ(frame.stages_ms.size(), frame.staged ? run.frames.stages.size() : 0u);
    }
    EXPECT_EQ(warm, 30u);
    EXPECT_EQ(counted, kTicks / 60);
    EXPECT_GE(staged, kTicks - kTicks / 32 - 1);
  }
}

TEST(Runner, SumsOfStagesAreTheirTicks) {
  Runs of;
  const PlayedRun run = of.runner.play(contenderChoices().front(), {kTicks, 0}, [](const Frame&) { return true; });
  for (const Frame& frame : run.frames.frames) {
    double sum = 0;
    for (const float stage_ms : frame.stages_ms) sum += stage_ms;
    EXPECT_LE(sum, frame.simulation_ms * 1.001 + 1e-3) << "tick " << frame.tick;
  }
}

TEST(Runner, EveryExactContenderFindsTheSameNeighboursAndTheThesisFewer) {
  Runs of;
  double first = 0;
  for (const ContenderChoice& contender : contenderChoices()) {
    double found = 0;
    of.runner.play(contender, {kTicks, 0}, [&](const Frame& frame) {
      if (frame.neighbours == frame.neighbours) found += frame.neighbours;
      return true;
    });
    if (first == 0) first = found;
    EXPECT_GT(found, 0);
    EXPECT_TRUE(contender.shadow() ? found <= first : found == first)
        << contender.name << ": " << found << " of " << first;
  }
}

TEST(Runner, RefusesAScenePlayedOtherwiseThanRecorded) {
  Runs of;
  of.scene.replay.hashes[99] ^= 1;
  for (const size_t contender : {0u, 4u}) {
    try {
      of.runner.play(contenderChoices()[contender], {kTicks, 0}, [](const Frame&) { return true; });
      ADD_FAILURE() << "played";
    } catch (const SceneDesync& error) {
      EXPECT_NE(std::string(error.what()).find("from tick 100 on"), std::string::npos) << error.what();
    }
  }
}

// In real time: frames without a tick, and of up to five.
TEST(Runner, PacedRunsTellTimesOfTicks) {
  Runs of;
  RunPlan plan{kTicks, 30};
  plan.paced = true;
  const PlayedRun run = of.runner.play(contenderChoices().front(), plan, [](const Frame&) { return true; });
  EXPECT_TRUE(run.whole);
  EXPECT_EQ(run.hash, of.scene.replay.hashes.back());
  EXPECT_EQ(run.frames.droppedTicks, run.frames.droppedTicks) << "known";
  uint32_t ticks = 0, counted = 0, without = 0;
  for (const Frame& frame : run.frames.frames) {
    ticks += frame.ticks;
    without += frame.ticks == 0;
    counted += frame.searching == frame.searching;
    EXPECT_LE(frame.ticks, FixedTimestep::kMostTicksPerFrame);
    EXPECT_EQ(frame.stages_ms.empty(), !frame.staged);
    EXPECT_TRUE(!frame.staged || frame.ticks > 0);
    double sum = 0;
    for (const float stage_ms : frame.stages_ms) sum += stage_ms;
    EXPECT_LE(sum * frame.ticks, frame.simulation_ms * 1.001 + 1e-3) << "tick " << frame.tick;
  }
  EXPECT_EQ(ticks, kTicks);
  EXPECT_GT(without, 0u) << "nothing is drawn, so frames come faster than ticks";
  EXPECT_EQ(counted, kTicks / 60);
}

TEST(Runner, ATickAFrameDropsNone) {
  Runs of;
  const PlayedRun run = of.runner.play(contenderChoices().front(), {30, 0}, [](const Frame&) { return true; });
  EXPECT_NE(run.frames.droppedTicks, run.frames.droppedTicks) << "nothing is due, so nothing is measured";
}

// A run in shadow is a track of a trace too.
TEST(Runner, FramesFollowOneAnother) {
  Runs of;
  for (const size_t contender : {0u, 4u}) {
    const PlayedRun run = of.runner.play(contenderChoices()[contender], {60, 0}, [](const Frame&) { return true; });
    double over_ms = 0;
    for (const Frame& frame : run.frames.frames) {
      EXPECT_GE(frame.begin_ms, over_ms - 1e-3) << "tick " << frame.tick;
      over_ms = frame.begin_ms;
      for (const float stage_ms : frame.stages_ms) over_ms += stage_ms;
    }
    EXPECT_GT(over_ms, 0);
  }
}

TEST(Runner, RefusesARecordingThatGoesOnAfterTheEnd) {
  Runs of;
  of.scene = recorded(SceneKind::swarm, 36000);
  of.config = replayConfig(of.scene.replay);
  const uint32_t ticks = of.scene.replay.ticks();
  of.scene.replay.inputs.push_back(of.scene.replay.inputs.back());
  of.scene.replay.hashes.push_back(of.scene.replay.hashes.back());
  EXPECT_THROW(of.runner.play(contenderChoices().front(), {ticks + 1, 0}, [](const Frame&) { return true; }),
               SceneDesync);
}

TEST(Runner, EndsWhenSomebodyWants) {
  Runs of;
  for (const size_t contender : {0u, 4u}) {
    const PlayedRun run =
        of.runner.play(contenderChoices()[contender], {kTicks, 0}, [](const Frame& frame) { return frame.tick < 17; });
    EXPECT_EQ(run.frames.frames.size(), 17u);
    EXPECT_FALSE(run.whole);
  }
}

}  // namespace
}  // namespace gw::profile
