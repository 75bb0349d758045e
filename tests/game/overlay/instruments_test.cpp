// The pure parts of the overlay: the history of frames, figures from readings, the notice, and switching the broad
// phase in the middle of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "game/overlay/broad_phase_switch.h"
#include "game/overlay/notice.h"
#include "game/overlay/overlay_figures.h"
#include "game/session/failover.h"
#include "game/tables/tables.h"
#include "gpu/devices/device_error.h"
#include "host/overlay/frame_history.h"
#include "tests/game/ui/remembering_canvas.h"

namespace gw {
namespace {

TEST(FrameHistory, RemembersTheLastFramesInOrder) {
  FrameHistory history;
  EXPECT_TRUE(history.empty());
  EXPECT_EQ(history.longest_ms(), 0);
  EXPECT_EQ(history.mean_ms(), 0);
  EXPECT_EQ(history.p99_ms(), 0);
  constexpr size_t kAdded = 2 * FrameHistory::kFrames + 17;
  std::vector<double> all;
  for (size_t i = 0; i < kAdded; ++i) {
    all.push_back(double(i % 100) + 1);
    history.add(all.back());
    const size_t kept = std::min(all.size(), FrameHistory::kFrames);
    ASSERT_EQ(history.oldestFirst_ms(), std::vector<double>(all.end() - ptrdiff_t(kept), all.end()));
  }
  history.clear();
  EXPECT_TRUE(history.oldestFirst_ms().empty());
}

TEST(FrameHistory, SaysWhatTheRememberedFramesTook) {
  FrameHistory history;
  history.add(500);  // forgotten again
  for (size_t i = 0; i < FrameHistory::kFrames; ++i) history.add(i % 2 == 0 ? 10 : 20);
  EXPECT_DOUBLE_EQ(history.mean_ms(), 15);
  EXPECT_DOUBLE_EQ(history.longest_ms(), 20);
  history.add(100);
  EXPECT_DOUBLE_EQ(history.longest_ms(), 100);
  EXPECT_LE(history.p99_ms(), 100);
  EXPECT_GE(history.p99_ms(), 20);
}

TEST(StageFigures, AreWhatTicksTookBetweenTwoReadings) {
  const std::vector<StageTime> before{{"logic", 10, 100}, {"think", 200, 100}};
  const auto figures = stageFigures(before, {{"logic", 12, 110}, {"think", 250, 110}, {"hash", 3, 6}});
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].name, "logic");
  EXPECT_DOUBLE_EQ(figures[0].perTick_ms, 0.2);
  EXPECT_DOUBLE_EQ(figures[1].perTick_ms, 5);
  EXPECT_EQ(figures[2].name, "hash");  // began after the first reading
  EXPECT_DOUBLE_EQ(figures[2].perTick_ms, 0.5);
}

TEST(StageFigures, AreNoneWhereNoTickWasTimed) {
  EXPECT_TRUE(stageFigures({}, {}).empty());
  EXPECT_TRUE(stageFigures({{"think", 200, 100}}, {{"think", 200, 100}}).empty());
}

TEST(StageFigures, OfAnotherSimulationBeginAnew) {
  const std::vector<StageTime> before{{"logic", 10, 100}, {"think", 200, 100}};
  const auto behind = stageFigures(before, {{"logic", 1, 4}, {"think", 8, 4}});
  ASSERT_EQ(behind.size(), 2u);
  EXPECT_DOUBLE_EQ(behind[1].perTick_ms, 2);
  const auto lacking = stageFigures(before, {{"think", 300, 150}});
  ASSERT_EQ(lacking.size(), 1u);
  EXPECT_DOUBLE_EQ(lacking[0].perTick_ms, 2);
}

TEST(OverlayFigures, DivideByWhoeverThereIs) {
  OverlayFigures figures;
  EXPECT_EQ(figures.candidatesPerEntity(), 0);
  EXPECT_EQ(figures.neighboursPerEntity(), 0);
  EXPECT_EQ(figures.misaligned_percent(), std::nullopt);
  figures.candidates = {.tested = 120, .found = 30, .entities = 40};
  figures.census.enemies[0] = 30;
  figures.census.enemies[7] = 12;
  figures.census.searched = 50;
  figures.census.misaligned = 5;
  EXPECT_DOUBLE_EQ(figures.candidatesPerEntity(), 3);
  EXPECT_DOUBLE_EQ(figures.neighboursPerEntity(), 0.75);
  EXPECT_EQ(figures.liveEnemies(), 42u);
  EXPECT_DOUBLE_EQ(figures.misaligned_percent().value(), 10);
  figures.census.searched = figures.census.misaligned.emplace(0);
  EXPECT_DOUBLE_EQ(figures.misaligned_percent().value(), 0);
}

TEST(Notice, IsShownForAMomentAndTheLastOneCounts) {
  Notice notice;
  const auto shows = [&](double now_s, const char* what) {
    RememberingCanvas canvas;
    notice.draw(canvas, now_s);
    return canvas.says(what);
  };
  EXPECT_FALSE(shows(0, ""));
  notice.say("broad phase: grid", 10);
  EXPECT_TRUE(shows(10, "broad phase: grid"));
  EXPECT_TRUE(shows(10 + Notice::kShown_s - 0.1, "broad phase: grid"));
  EXPECT_FALSE(shows(10 + Notice::kShown_s, ""));
  notice.say("one", 20);
  notice.say("two", 21);
  EXPECT_FALSE(shows(21, "one"));
  EXPECT_TRUE(shows(22.5, "two"));
}

TEST(Notice, FitsTheWindowHoweverLongItIs) {
  Notice notice;
  notice.say(std::string(400, 'x'), 0);
  RememberingCanvas canvas;
  notice.draw(canvas, 1);
  ASSERT_EQ(canvas.texts.size(), 1u);
  EXPECT_LE(canvas.textWidth(canvas.texts[0].text, canvas.texts[0].style.size_px), canvas.width());
}

using GameRun = Run;  // googletest has a Run of its own

class BroadPhaseSwitch : public testing::Test {
 protected:
  static constexpr uint32_t kTicks = 160;

  static SimulationConfig config(Autopilot autopilot = Autopilot::none) {
    SimulationConfig config;
    config.rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
    config.enemies = 300;
    config.mode = Mode::swarm;
    config.threads = 1;
    config.autopilot = autopilot;
    return config;
  }

  static InputRecord keys(uint32_t tick) {
    return {int16_t(tick * 7919 % 20001 - 10000), int16_t(tick * 104729 % 20001 - 10000), uint16_t(tick * 331),
            uint16_t(tick % 3 == 0)};
  }

  static GameRun runOf(const SimulationConfig& config) { return {cpu::makeSimulation(config), std::nullopt}; }

  static void expectSame(const TickReport& is, const TickReport& wanted) {
    EXPECT_EQ(is.hash, wanted.hash) << "tick " << wanted.tick;
    EXPECT_EQ(is.score, wanted.score);
    EXPECT_EQ(is.enemies, wanted.enemies);
    EXPECT_EQ(is.tick, wanted.tick);
  }
};

TEST_F(BroadPhaseSwitch, GoesRoundAllFour) {
  BroadPhase broadPhase = BroadPhase::ngrid;
  for (const BroadPhase next : {BroadPhase::grid, BroadPhase::gridHashed, BroadPhase::bruteForce, BroadPhase::ngrid}) {
    broadPhase = broadPhaseAfter(broadPhase);
    EXPECT_EQ(broadPhase, next);
  }
}

TEST_F(BroadPhaseSwitch, IsNotFeltByTheGameThroughAllFour) {
  for (const Autopilot autopilot : {Autopilot::none, Autopilot::expert}) {
    GameRun plain = runOf(config(autopilot)), switched = runOf(config(autopilot));
    std::vector<std::string> told;
    for (uint32_t t = 0; t < kTicks; ++t) {
      if (t % 20 == 10) told.push_back(switchBroadPhase(switched, cpu::makeSimulation));
      plain.tick(keys(t));
      switched.tick(keys(t));
      expectSame(switched.last(), plain.last());
      if (t % 40 == 19) {
        const Snapshot is = switched.simulation().snapshot(), wanted = plain.simulation().snapshot();
        EXPECT_EQ(is.globals, wanted.globals);
        ASSERT_EQ(is.entities.size(), wanted.entities.size());
        EXPECT_EQ(std::memcmp(is.entities.data(), wanted.entities.data(), is.entities.size() * sizeof(EntityRecord)),
                  0);
      }
    }
    EXPECT_GT(plain.last().enemies, 100u);
    ASSERT_EQ(told.size(), kTicks / 20);
    EXPECT_EQ(told[0], "broad phase: grid");
    EXPECT_EQ(told[1], "broad phase: grid-hashed");
    EXPECT_EQ(told[2], "broad phase: brute");
    EXPECT_EQ(told[3], "broad phase: ngrid");
  }
}

TEST_F(BroadPhaseSwitch, BeforeTheFirstTickIsNotFeltEither) {
  GameRun plain = runOf(config()), switched = runOf(config());
  switchBroadPhase(switched, cpu::makeSimulation);
  EXPECT_EQ(switched.simulation().config().broadPhase, BroadPhase::grid);
  for (uint32_t t = 0; t < 30; ++t) {
    plain.tick(keys(t));
    switched.tick(keys(t));
    expectSame(switched.last(), plain.last());
  }
}

TEST_F(BroadPhaseSwitch, GoesOnTimingStagesWhereTheyWereTimed) {
  GameRun run = runOf(config());
  switchBroadPhase(run, cpu::makeSimulation);
  EXPECT_FALSE(run.simulation().timesStages());
  run.simulation().enableStageTimes(true);
  switchBroadPhase(run, cpu::makeSimulation);
  EXPECT_TRUE(run.simulation().timesStages());
}

TEST_F(BroadPhaseSwitch, RefusesAnInexactGame) {
  SimulationConfig inexact = config();
  inexact.gather = Gather::adaptive;
  GameRun run = runOf(inexact);
  const Simulation* before = &run.simulation();
  EXPECT_EQ(switchBroadPhase(run, cpu::makeSimulation),
            "broad phase: still ngrid, because an inexact game has only one");
  EXPECT_EQ(&run.simulation(), before);
}

TEST_F(BroadPhaseSwitch, KeepsTheGameWhenThereIsNoOther) {
  GameRun run = runOf(config());
  const Simulation* before = &run.simulation();
  run.tick({});
  const std::string told = switchBroadPhase(run, [](const SimulationConfig&) -> std::unique_ptr<Simulation> {
    throw DeviceOutOfMemory("the device is full.");
  });
  EXPECT_EQ(told, "broad phase: still ngrid, because of this: the device is full.");
  EXPECT_EQ(&run.simulation(), before);
  run.tick({});
  EXPECT_EQ(run.last().tick, 2u);
}

TEST_F(BroadPhaseSwitch, GoesOnWithAGameThatOutlivesItsDevice) {
  const auto lasting = [](const SimulationConfig& config) -> std::unique_ptr<Simulation> {
    return std::make_unique<Failover>(
        cpu::makeSimulation(config), [config] { return cpu::makeSimulation(config); }, [](const std::string&) {});
  };
  GameRun plain = runOf(config(Autopilot::expert)), switched = {lasting(config(Autopilot::expert)), std::nullopt};
  for (uint32_t t = 0; t < kTicks; ++t) {
    if (t % 40 == 10) switchBroadPhase(switched, lasting);
    if (t % 40 == 25) switched.simulation().dropDevice("a test wants it");
    plain.tick(keys(t));
    switched.tick(keys(t));
    expectSame(switched.last(), plain.last());
  }
  EXPECT_EQ(switched.simulation().config().broadPhase, BroadPhase::ngrid) << "all four have played";
  EXPECT_FALSE(switched.simulation().dropped().empty());
}

TEST_F(BroadPhaseSwitch, NeedsTicksToBeCollected) {
  GameRun run = runOf(config());
  run.queue({});
  EXPECT_THROW(run.replaceSimulation(cpu::makeSimulation(config())), std::logic_error);
  run.collect();
  EXPECT_NO_THROW(run.replaceSimulation(cpu::makeSimulation(config())));
}

TEST_F(BroadPhaseSwitch, FiguresFollowTheSimulationInUse) {
  GameRun run = runOf(config());
  run.simulation().enableStageTimes(true);
  FigureGatherer gatherer;
  EXPECT_FALSE(gatherer.figures().known);
  for (uint32_t t = 0; t < 5; ++t) run.tick(keys(t));
  gatherer.look(run.simulation(), 100);
  EXPECT_TRUE(gatherer.figures().known);
  EXPECT_EQ(gatherer.figures().broadPhase, BroadPhase::ngrid);
  EXPECT_EQ(gatherer.figures().stages.size(), 9u);
  EXPECT_GT(gatherer.figures().stages_ms(), 0);
  EXPECT_EQ(gatherer.figures().liveEnemies(), run.last().enemies);
  EXPECT_GT(gatherer.figures().candidatesPerEntity(), 0);
  EXPECT_TRUE(gatherer.figures().misaligned_percent().has_value());
  EXPECT_EQ(gatherer.figures().deviceBytes, run.simulation().deviceBytes());

  switchBroadPhase(run, cpu::makeSimulation);
  gatherer.look(run.simulation(), 100 + FigureGatherer::kEvery_s / 2);
  EXPECT_EQ(gatherer.figures().broadPhase, BroadPhase::ngrid) << "it is not time yet";
  gatherer.forget();
  gatherer.look(run.simulation(), 100 + FigureGatherer::kEvery_s / 2);
  EXPECT_EQ(gatherer.figures().broadPhase, BroadPhase::grid);
  EXPECT_TRUE(gatherer.figures().stages.empty()) << "no tick of this simulation was timed";
  EXPECT_EQ(gatherer.figures().misaligned_percent(), std::nullopt);
}

TEST_F(BroadPhaseSwitch, FiguresOfStagesStayWhileNothingIsPlayed) {
  GameRun run = runOf(config());
  run.simulation().enableStageTimes(true);
  FigureGatherer gatherer;
  for (uint32_t t = 0; t < 3; ++t) run.tick(keys(t));
  gatherer.look(run.simulation(), 1);
  const double before_ms = gatherer.figures().stages_ms();
  gatherer.look(run.simulation(), 1000);
  EXPECT_EQ(gatherer.figures().stages_ms(), before_ms);
}

}  // namespace
}  // namespace gw
