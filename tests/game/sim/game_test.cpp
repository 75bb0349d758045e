// Whole games: how they are computed changes nothing, they end, and they start again the same.
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <stdexcept>

#include "gpu/ngrid/ngrid.h"
#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

// 500 enemies in a game for 1,024, played by the expert; the reference that all variants are held against.
constexpr uint32_t kEnemies = 500, kTicks = 600;

SimulationConfig referenceConfig() {
  SimulationConfig config = stageConfig(1024);
  config.autopilot = Autopilot::expert;
  return config;
}

const std::vector<TickReport>& reference() {
  static const std::vector<TickReport> reports = [] {
    const SimulationConfig config = referenceConfig();
    const auto simulation = cpu::makeSimulation(config);
    simulation->restore(crowdScene(config, kEnemies));
    return play(*simulation, kTicks);
  }();
  return reports;
}

// The same game from its recorded inputs, computed in another way.
void expectSame(SimulationConfig config, uint32_t ticks) {
  const auto inputs = inputsOf(reference());
  const auto wanted = hashesOf(reference());
  config.autopilot = Autopilot::none;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  const auto is = hashesOf(play(*simulation, ticks, inputs));
  for (uint32_t t = 0; t < ticks; ++t) ASSERT_EQ(is[t], wanted[t]) << "tick " << t;
}

TEST(game, the_reference_is_worth_comparing) {
  const auto& reports = reference();
  const TickReport& last = reports.back();
  EXPECT_GT(reports.front().enemies, 490u);
  EXPECT_GT(last.kills, 50u);
  EXPECT_GT(last.bitsTaken, 5u);
  std::set<uint64_t> hashes;
  for (const TickReport& r : reports) hashes.insert(r.hash);
  EXPECT_EQ(hashes.size(), size_t(kTicks));
}

struct Way {
  const char* name;
  uint32_t threads;
  VisitOrder order;
  BroadPhase broadPhase;
  bool protect;
  uint32_t ticks;
  Sort sort = Sort::bitonic;
};
class game_computed : public ::testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(
    by, game_computed,
    ::testing::Values(Way{"one_thread", 1, VisitOrder::forward, BroadPhase::ngrid, false, kTicks},
                      Way{"two_threads", 2, VisitOrder::forward, BroadPhase::ngrid, false, kTicks},
                      Way{"seven_threads", 7, VisitOrder::forward, BroadPhase::ngrid, false, 200},
                      Way{"reversed_visits", 2, VisitOrder::reversed, BroadPhase::ngrid, false, kTicks},
                      Way{"shuffled_visits", 2, VisitOrder::shuffled, BroadPhase::ngrid, false, kTicks},
                      Way{"full_sort", 2, VisitOrder::forward, BroadPhase::ngrid, false, kTicks, Sort::full},
                      Way{"shuffled_full_sort", 2, VisitOrder::shuffled, BroadPhase::ngrid, true, 300, Sort::full},
                      Way{"frozen_rows", 2, VisitOrder::forward, BroadPhase::ngrid, false, kTicks, Sort::frozen},
                      Way{"shuffled_frozen_rows", 2, VisitOrder::shuffled, BroadPhase::ngrid, true, 300, Sort::frozen},
                      Way{"grid", 2, VisitOrder::forward, BroadPhase::grid, false, kTicks},
                      Way{"shuffled_grid", 2, VisitOrder::shuffled, BroadPhase::grid, true, 300},
                      Way{"hashed_grid", 2, VisitOrder::forward, BroadPhase::gridHashed, false, kTicks},
                      Way{"shuffled_hashed_grid", 2, VisitOrder::shuffled, BroadPhase::gridHashed, true, 300},
                      Way{"brute_force", 1, VisitOrder::forward, BroadPhase::bruteForce, false, 300},
                      Way{"shuffled_brute_force", 2, VisitOrder::shuffled, BroadPhase::bruteForce, false, 100},
                      Way{"protected_memory", 2, VisitOrder::forward, BroadPhase::ngrid, true, 300}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_P(game_computed, gives_the_same_hash_at_every_tick) {
  const Way& way = GetParam();
  SimulationConfig config = referenceConfig();
  config.threads = way.threads;
  config.order = way.order;
  config.broadPhase = way.broadPhase;
  config.protectMemory = way.protect;
  config.sort = way.sort;
  expectSame(config, way.ticks);
}

// Frozen rows widen tick by tick, and are sorted in full as soon as a report says that they have widened too much.
TEST(game, frozen_rows_are_sorted_in_full_when_they_have_widened) {
  const auto inputs = inputsOf(reference());
  SimulationConfig config = referenceConfig();
  config.autopilot = Autopilot::none;
  config.sort = Sort::frozen;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  uint32_t sorted = 0, wide = 0;
  float before = 0.0f;
  for (uint32_t t = 0; t < 300; ++t) {
    simulation->tick(inputs[t]);
    const float now = simulation->report().rowsWidened;
    ASSERT_TRUE(now > 0.0f && now < 100.0f) << t;
    if (before > cpu::kWorthRebuilding) {
      ASSERT_EQ(now, 1.0f) << t;
      ++sorted;
    }
    wide += now > 1.0f;
    before = now;
  }
  EXPECT_GT(sorted, 3u);
  EXPECT_LT(sorted, 100u);
  EXPECT_GT(wide, 150u);
}

TEST(game, queued_ticks_are_the_same_as_single_ones) {
  const auto inputs = inputsOf(reference());
  const auto wanted = hashesOf(reference());
  SimulationConfig config = referenceConfig();
  config.autopilot = Autopilot::none;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  for (uint32_t t = 0; t < 40; t += Simulation::kTicksInFlight) {
    for (uint32_t k = 0; k < Simulation::kTicksInFlight; ++k) simulation->tick(inputs[t + k]);
    EXPECT_THROW(simulation->tick({}), std::logic_error);
    for (uint32_t k = 0; k < Simulation::kTicksInFlight; ++k) ASSERT_EQ(simulation->report().hash, wanted[t + k]);
    EXPECT_THROW(simulation->report(), std::logic_error);
  }
}

TEST(game, looking_does_not_touch_it) {
  const auto inputs = inputsOf(reference());
  const auto wanted = hashesOf(reference());
  SimulationConfig config = referenceConfig();
  config.autopilot = Autopilot::none;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  std::vector<SpriteVertex> sprites(2000);
  DrawArraysCommand command;
  for (uint32_t t = 0; t < 60; ++t) {
    simulation->enableStageTimes(t % 3 == 0);
    simulation->tick(inputs[t]);
    ASSERT_EQ(simulation->report().hash, wanted[t]) << t;
    const Colouring colouring = t % 2 == 0 ? Colouring::types : Colouring::rows;
    simulation->drawList({96.0f, 54.0f, 40.0f, 20.0f, colouring}, {sprites.data(), 2000, &command});
    EXPECT_GT(simulation->countCandidates().tested, 0u);
    simulation->snapshot();
    simulation->park();
  }
  EXPECT_EQ(simulation->stageTimes().size(), 9u);
}

TEST(game, eight_thousand_enemies_at_once_are_alive_and_the_rest_is_refused) {
  SimulationConfig config = stageConfig(8192);
  config.threads = 2;
  Snapshot scene = crowdScene(config, 8192);
  GameGlobals globals = globalsOf(scene);
  globals.waveClock_ticks = config.rules.waves[5].at_ticks;  // a wave is due, and there is no room
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
  uint32_t refused = 0;
  for (uint32_t g = 0; g < config.rules.waves[5].groupCount; ++g) refused += config.rules.waves[5].groups[g].count;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(scene);
  const auto reports = play(*simulation, 20, std::vector<InputRecord>(20, {0, 0, 0, kButtonFire}));
  EXPECT_EQ(reports[0].enemies, 8192u);
  EXPECT_EQ(reports[0].refused, refused);
  EXPECT_EQ(reports[0].shots, config.rules.shot.levels[3].count);  // the guns still work
  EXPECT_EQ(reports.back().peakEnemies, 8192u);
  SimulationConfig brute = config;
  brute.broadPhase = BroadPhase::bruteForce;
  const auto oracle = cpu::makeSimulation(brute);
  oracle->restore(scene);
  oracle->tick({0, 0, 0, kButtonFire});
  EXPECT_EQ(oracle->report().hash, reports[0].hash);
}

TEST(game, ends_for_the_novice_and_then_stands_still) {
  SimulationConfig config = stageConfig(2048);
  config.autopilot = Autopilot::novice;
  config.seed = 3;
  const auto simulation = cpu::makeSimulation(config);
  TickReport report;
  for (uint32_t t = 0; t < 30000 && !report.over; ++t) {
    simulation->tick({});
    const TickReport now = simulation->report();
    ASSERT_EQ(now.tick, t + 1);
    ASSERT_EQ(now.frameTime_us > config.rules.budget.limit_us, now.over != 0);
    report = now;
  }
  ASSERT_EQ(report.over, 1u);
  EXPECT_GT(report.frameTime_us, config.rules.budget.limit_us);
  EXPECT_GT(report.contacts, 4u);
  EXPECT_GT(report.score, 0u);
  EXPECT_EQ(report.sounds[uint32_t(SoundEvent::over)][1], 1u);
  EXPECT_EQ(report.sounds[uint32_t(SoundEvent::contact)][1], 1u);
  EXPECT_NE(report.contactType, uint32_t(kTypeNone));
  const Snapshot end = simulation->snapshot();
  for (int t = 0; t < 10; ++t) {
    simulation->tick({kStickFull, kStickFull, 77, 3});
    const TickReport after = simulation->report();
    EXPECT_EQ(after.hash, report.hash);
    EXPECT_EQ(after.tick, report.tick);
    for (const auto& event : after.sounds) {
      for (const uint16_t count : event) EXPECT_EQ(count, 0u);
    }
    const Snapshot now = simulation->snapshot();
    EXPECT_EQ(now.globals, end.globals);
    EXPECT_TRUE(same(now.entities, end.entities));
  }
}

TEST(game, starts_again_the_same_and_seeds_differ) {
  SimulationConfig config = stageConfig();
  config.autopilot = Autopilot::novice;
  const auto run = [&](uint64_t seed) {
    config.seed = seed;
    return hashesOf(play(*cpu::makeSimulation(config), 300));
  };
  const auto first = run(1);
  EXPECT_EQ(run(1), first);
  const auto other = run(2);
  for (uint32_t t = 0; t < 300; ++t) ASSERT_NE(first[t], other[t]) << t;
}

TEST(game, a_tick_is_as_few_launches_as_the_docs_say) {
  SimulationConfig config = stageConfig();
  config.protectMemory = false;
  for (const auto& [autopilot, particles, launches] :
       {std::tuple{Autopilot::none, false, 16u}, {Autopilot::expert, false, 17u}, {Autopilot::none, true, 19u}}) {
    config.autopilot = autopilot;
    config.particles = particles;
    const auto simulation = cpu::makeSimulation(config);
    simulation->tick({});
    simulation->report();
    EXPECT_EQ(simulation->launchesPerTick(), launches);
  }
}

TEST(game, instant_restart_in_the_same_simulation_gives_the_same_hashes) {
  SimulationConfig config = stageConfig();
  config.autopilot = Autopilot::novice;
  const auto simulation = cpu::makeSimulation(config);
  const Snapshot start = simulation->snapshot();
  const auto wanted = hashesOf(play(*simulation, 333));
  simulation->restore(start);
  EXPECT_EQ(hashesOf(play(*simulation, 333)), wanted);
}

}  // namespace
}  // namespace gw::test
