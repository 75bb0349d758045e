// Whole games with an inexact gather: the arrangement of the cells is state. Nothing else about how they are computed
// changes the game, and snapshots and replays carry all of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

struct Way {
  const char* name;
  Gather gather;
  Sort sort;
};
constexpr Way kWays[] = {{"thesis", Gather::adaptive, Sort::bitonic},
                         {"adaptive_odd_even", Gather::adaptive, Sort::oddEven},
                         {"fixed_bitonic", Gather::fixed, Sort::bitonic},
                         {"fixed_odd_even", Gather::fixed, Sort::oddEven}};

constexpr uint32_t kEnemies = 400, kTicks = 240;

SimulationConfig configOf(const Way& way) {
  SimulationConfig config = stageConfig(1024);
  config.gather = way.gather;
  config.sort = way.sort;
  config.autopilot = Autopilot::expert;
  return config;
}

std::vector<TickReport> playScene(const SimulationConfig& config, const std::vector<InputRecord>& inputs = {}) {
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  return play(*simulation, kTicks, inputs);
}

bool equal(const Snapshot& a, const Snapshot& b) {
  return a.globals == b.globals && a.arrangement == b.arrangement && bool(same(a.entities, b.entities));
}

class inexact_game : public ::testing::TestWithParam<Way> {
 protected:
  SimulationConfig config = configOf(GetParam());
};
INSTANTIATE_TEST_SUITE_P(by, inexact_game, ::testing::ValuesIn(kWays),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(inexact_game, no_thread_or_order_of_visits_is_felt) {
  const auto wanted = playScene(config);
  EXPECT_GT(wanted.back().enemies, 100u);
  config.autopilot = Autopilot::none;
  const auto is = [&](uint32_t threads, VisitOrder order, bool protect) {
    config.threads = threads;
    config.order = order;
    config.protectMemory = protect;
    return hashesOf(playScene(config, inputsOf(wanted)));
  };
  EXPECT_EQ(is(1, VisitOrder::shuffled, false), hashesOf(wanted));
  EXPECT_EQ(is(2, VisitOrder::reversed, false), hashesOf(wanted));
  EXPECT_EQ(is(7, VisitOrder::forward, false), hashesOf(wanted));
  EXPECT_EQ(is(2, VisitOrder::forward, true), hashesOf(wanted));
}

TEST_P(inexact_game, is_another_game_than_the_exact_one) {
  SimulationConfig exact = config;
  exact.gather = Gather::exact;
  exact.sort = Sort::bitonic;
  EXPECT_NE(hashesOf(playScene(config)), hashesOf(playScene(exact)));
}

TEST_P(inexact_game, goes_on_from_a_snapshot_hash_for_hash) {
  const auto whole = cpu::makeSimulation(config);
  whole->restore(crowdScene(config, kEnemies));
  const auto wanted = hashesOf(play(*whole, kTicks));
  for (const uint32_t at : {1u, 60u, 151u}) {
    const auto first = cpu::makeSimulation(config), second = cpu::makeSimulation(config);
    first->restore(crowdScene(config, kEnemies));
    play(*first, at);
    const Snapshot then = first->snapshot();
    ASSERT_EQ(then.arrangement.size(), first->capacity());
    second->restore(then);
    EXPECT_TRUE(equal(second->snapshot(), then));
    EXPECT_EQ(hashesOf(play(*second, kTicks - at)), std::vector(wanted.begin() + at, wanted.end())) << at;
    // The same simulation goes back in time as well.
    play(*first, 33);
    first->restore(then);
    EXPECT_EQ(hashesOf(play(*first, 20)), std::vector(wanted.begin() + at, wanted.begin() + at + 20)) << at;
  }
}

TEST_P(inexact_game, is_played_again_from_its_replay) {
  Replay replay;
  replay.header.enemies = config.enemies;
  replay.header.seed = config.seed;
  replay.header.gather = config.gather;
  replay.header.sort = config.sortInUse();
  replay.rules = readRuleTexts(GW_ASSETS_DIR);
  const auto reports = play(*cpu::makeSimulation(config), 600);  // from the start of a game: the bot's own waves
  EXPECT_GT(reports.back().enemies, 0u);
  replay.inputs = inputsOf(reports);
  replay.hashes = hashesOf(reports);
  const Replay read = decodeReplay(encodeReplay(replay), "x.gwr");
  SimulationConfig again = replayConfig(read);
  again.threads = 2;
  EXPECT_EQ(hashesOf(play(*cpu::makeSimulation(again), 600, read.inputs)), replay.hashes);
}

TEST_P(inexact_game, stands_still_once_it_is_over) {
  Snapshot scene = crowdScene(config, 100);
  GameGlobals globals = globalsOf(scene);
  globals.frameTime_us = config.rules.budget.limit_us + 1;
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(scene);
  const TickReport last = play(*simulation, 1)[0];
  ASSERT_EQ(last.over, 1u);
  const Snapshot end = simulation->snapshot();
  for (const TickReport& report : play(*simulation, 9, std::vector<InputRecord>(9, {kStickFull, 0, 9, 3}))) {
    EXPECT_EQ(report.hash, last.hash);
  }
  EXPECT_TRUE(equal(simulation->snapshot(), end));
}

TEST(inexact_snapshot, a_damaged_arrangement_is_refused_and_changes_nothing) {
  const SimulationConfig config = configOf(kWays[0]);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, 100));
  play(*simulation, 10);
  const Snapshot good = simulation->snapshot();
  const auto refused = [&](const char* what, auto&& damage) {
    Snapshot bad = good;
    damage(bad.arrangement);
    EXPECT_THROW(simulation->restore(bad), std::invalid_argument) << what;
    EXPECT_TRUE(equal(simulation->snapshot(), good)) << what;
  };
  refused("a cell too few", [](auto& a) { a.pop_back(); });
  refused("a cell too many", [](auto& a) { a.push_back(0); });
  refused("an id twice", [](auto& a) { a[7] = a[8]; });
  refused("an id past the capacity", [](auto& a) { a[7] = uint32_t(a.size()); });
  refused("an id far past it", [](auto& a) { a[7] = 0xFFFFFFFFu; });
}

TEST(inexact_snapshot, exact_games_keep_none_and_take_no_notice) {
  SimulationConfig config = stageConfig(1024);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, 100));
  Snapshot snapshot = simulation->snapshot();
  EXPECT_TRUE(snapshot.arrangement.empty());
  const auto wanted = hashesOf(play(*simulation, 20));
  snapshot.arrangement = {5, 5, 5};
  simulation->restore(snapshot);
  EXPECT_EQ(hashesOf(play(*simulation, 20)), wanted);
}

TEST(inexact_config, what_does_not_go_together_is_refused) {
  SimulationConfig config = stageConfig();
  config.sort = Sort::oddEven;
  EXPECT_THROW(cpu::makeSimulation(config), std::invalid_argument);
  config.gather = Gather::adaptive;
  EXPECT_NO_THROW(cpu::makeSimulation(config));
  config.broadPhase = BroadPhase::bruteForce;
  EXPECT_THROW(cpu::makeSimulation(config), std::invalid_argument);
}

// They look at every entity, whatever the grid would show.
TEST(inexact_bots, decide_as_in_an_exact_game) {
  for (const Way& way : kWays) {
    for (uint32_t seed = 1; seed <= 4; ++seed) {
      SimulationConfig config = configOf(way);
      const Snapshot scene = crowdScene(config, 900, seed);
      const auto inexact = cpu::makeSimulation(config);
      config.gather = Gather::exact;
      config.sort = Sort::bitonic;
      const auto exact = cpu::makeSimulation(config);
      inexact->restore(scene);
      exact->restore(scene);
      const InputRecord wanted = play(*exact, 1)[0].input;
      EXPECT_NE(wanted.buttons, 0u);
      EXPECT_EQ(play(*inexact, 1)[0].input, wanted) << way.name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace gw::test
