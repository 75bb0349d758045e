// Snapshots: the same bytes come back, the game goes on as if nothing had happened, and what does not fit is
// refused.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

bool equal(const Snapshot& a, const Snapshot& b) {
  return a.globals == b.globals && bool(same(a.entities, b.entities));
}

SimulationConfig configWith(BroadPhase broadPhase, Autopilot autopilot = Autopilot::none) {
  SimulationConfig config = stageConfig(512);
  config.broadPhase = broadPhase;
  config.autopilot = autopilot;
  return config;
}

TEST(snapshot, comes_back_byte_by_byte) {
  const SimulationConfig config = configWith(BroadPhase::ngrid, Autopilot::expert);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, 200));
  for (int round = 0; round < 5; ++round) {
    play(*simulation, 31);  // odd: both halves of the buffers get their turn
    const Snapshot before = simulation->snapshot();
    EXPECT_GT(before.entities.size(), 150u);
    simulation->restore(before);
    EXPECT_TRUE(equal(simulation->snapshot(), before));
    const auto other = cpu::makeSimulation(config);
    other->restore(before);
    EXPECT_TRUE(equal(other->snapshot(), before));
  }
}

class snapshot_continued : public ::testing::TestWithParam<std::tuple<BroadPhase, Autopilot>> {};
INSTANTIATE_TEST_SUITE_P(all, snapshot_continued,
                         ::testing::Combine(::testing::Values(BroadPhase::ngrid, BroadPhase::grid,
                                                              BroadPhase::gridHashed, BroadPhase::bruteForce),
                                            ::testing::Values(Autopilot::none, Autopilot::novice, Autopilot::expert)));

TEST_P(snapshot_continued, gives_the_hashes_of_the_uninterrupted_game) {
  const auto [broadPhase, autopilot] = GetParam();
  const SimulationConfig config = configWith(broadPhase, autopilot);
  const Snapshot scene = crowdScene(config, 150);
  std::vector<InputRecord> inputs;
  for (uint32_t t = 0; t < 200; ++t) {
    inputs.push_back(
        {int16_t(300 * int(t % 200) - 30000), int16_t(t % 50 * 600), uint16_t(t * 700), uint16_t(t % 90 ? 1 : 3)});
  }
  const auto whole = cpu::makeSimulation(config);
  whole->restore(scene);
  const auto wanted = hashesOf(play(*whole, 200, inputs));
  for (const uint32_t at : {1u, 77u, 130u}) {
    const auto first = cpu::makeSimulation(config), second = cpu::makeSimulation(config);
    first->restore(scene);
    play(*first, at, inputs);
    second->restore(first->snapshot());
    const auto is = hashesOf(play(*second, 200 - at, {inputs.begin() + at, inputs.end()}));
    EXPECT_EQ(is, std::vector(wanted.begin() + at, wanted.end())) << "from tick " << at;
  }
}

TEST(snapshot, goes_back_in_time_in_the_same_simulation) {
  const SimulationConfig config = configWith(BroadPhase::ngrid, Autopilot::novice);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, 150));
  play(*simulation, 55);
  const Snapshot then = simulation->snapshot();
  const auto wanted = hashesOf(play(*simulation, 60));
  simulation->restore(then);
  EXPECT_EQ(hashesOf(play(*simulation, 60)), wanted);
}

TEST(snapshot, what_does_not_fit_is_refused_and_changes_nothing) {
  const SimulationConfig config = configWith(BroadPhase::ngrid);
  const auto simulation = cpu::makeSimulation(config);
  const Snapshot good = crowdScene(config, 100);
  simulation->restore(good);
  play(*simulation, 10);
  const Snapshot before = simulation->snapshot();
  const auto refused = [&](const char* what, auto&& damage) {
    Snapshot bad = good;
    damage(bad);
    EXPECT_THROW(simulation->restore(bad), std::invalid_argument) << what;
    EXPECT_TRUE(equal(simulation->snapshot(), before)) << what;
  };
  refused("short globals", [](Snapshot& s) { s.globals.pop_back(); });
  refused("no globals", [](Snapshot& s) { s.globals.clear(); });
  refused("an id past the capacity", [&](Snapshot& s) { s.entities.back().id = simulation->capacity(); });
  refused("ids out of order", [](Snapshot& s) { std::swap(s.entities[3], s.entities[4]); });
  refused("one id twice", [](Snapshot& s) { s.entities[4].id = s.entities[3].id; });
  refused("no known type", [](Snapshot& s) { s.entities[5].type = kTypeCount; });
  refused("the type of a dead cell", [](Snapshot& s) { s.entities[5].type = kTypeNone; });
  refused("an enemy that the rules do not know",
          [&](Snapshot& s) { s.entities[5].type = config.rules.enemyTypeCount; });
  refused("an enemy in no known state", [](Snapshot& s) { s.entities[5].state = uint32_t(State::count); });
  refused("a place at infinity", [](Snapshot& s) { s.entities[5].x = std::numeric_limits<float>::infinity(); });
  refused("a place that is no number", [](Snapshot& s) { s.entities[5].y = std::numeric_limits<float>::quiet_NaN(); });
}

// Frozen rows are sorted in full when a report says that they have widened. Such a report of the ticks before a
// restored snapshot once had the first tick sort an empty grid, and the horde of the next tick stood in its
// rows by id: the same game, with four times the candidates.
TEST(snapshot, of_the_start_leaves_no_rows_to_sort_for_what_was_before) {
  SimulationConfig config = stageConfig(2500);
  config.autopilot = Autopilot::expert;
  config.mode = Mode::swarm;
  const auto fresh = cpu::makeSimulation(config);
  const Snapshot start = fresh->snapshot();
  play(*fresh, 200);
  const Snapshot later = fresh->snapshot();
  std::vector<uint64_t> wanted;
  fresh->restore(start);
  for (uint32_t t = 0; t < 10; ++t) {
    play(*fresh, 1);
    wanted.push_back(fresh->countCandidates().tested);
  }
  bool widened = false;
  for (uint32_t before = 1; before < 6; ++before) {
    const auto simulation = cpu::makeSimulation(config);
    simulation->restore(later);
    widened |= play(*simulation, before).back().rowsWidened > 1.05f;
    simulation->restore(start);
    for (uint32_t t = 0; t < 10; ++t) {
      play(*simulation, 1);
      EXPECT_EQ(simulation->countCandidates().tested, wanted[t]) << "tick " << t + 1 << " after " << before;
    }
  }
  EXPECT_TRUE(widened) << "no report said so: this shows nothing";
}

TEST(snapshot, of_a_larger_game_is_refused_by_a_smaller_one) {
  SimulationConfig large = stageConfig(8192);
  const auto small = cpu::makeSimulation(stageConfig(64));
  EXPECT_THROW(small->restore(crowdScene(large, 8000)), std::invalid_argument);
}

TEST(snapshot, of_a_finished_game_stays_finished) {
  const SimulationConfig config = configWith(BroadPhase::ngrid);
  Snapshot scene = crowdScene(config, 100);
  GameGlobals globals = globalsOf(scene);
  globals.frameTime_us = config.rules.budget.limit_us + 1;
  std::memcpy(scene.globals.data(), &globals, sizeof globals);
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(scene);
  EXPECT_EQ(play(*simulation, 1)[0].over, 1u);
  const Snapshot end = simulation->snapshot();
  const auto other = cpu::makeSimulation(config);
  other->restore(end);
  const auto reports = play(*other, 5, std::vector<InputRecord>(5, {kStickFull, 0, 9, 3}));
  for (const TickReport& report : reports) EXPECT_EQ(report.over, 1u);
  EXPECT_TRUE(equal(other->snapshot(), end));
}

}  // namespace
}  // namespace gw::test
