// The census: live entities and the order of the grid, as a host counts them on a snapshot. Counting changes no game.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "game/sim/broad_phase.h"
#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

constexpr uint32_t kEnemies = 500;

SimulationConfig botConfig() {
  SimulationConfig config = stageConfig(1024);
  config.autopilot = Autopilot::expert;
  config.threads = 2;
  return config;
}

Census countedOn(const Snapshot& snapshot) {
  Census census;
  for (const EntityRecord& e : snapshot.entities) {
    if (e.type < kMaxEnemyTypes) census.enemies[e.type] += e.state != uint32_t(State::dead);
    census.shots += e.type == kTypeShot;
    census.bits += e.type == kTypeBit;
  }
  return census;
}

TEST(census, counts_who_lives_by_type) {
  const auto simulation = cpu::makeSimulation(botConfig());
  simulation->restore(crowdScene(botConfig(), kEnemies));
  uint32_t shots = 0, bits = 0;
  for (uint32_t t = 0; t < 200; ++t) {
    simulation->tick({});
    const TickReport report = simulation->report();
    const Census is = simulation->census(), wanted = countedOn(simulation->snapshot());
    ASSERT_TRUE(std::equal(std::begin(is.enemies), std::end(is.enemies), wanted.enemies)) << "tick " << t;
    ASSERT_EQ(is.shots, wanted.shots);
    ASSERT_EQ(is.bits, wanted.bits);
    ASSERT_EQ(is.shots, report.shots);
    ASSERT_GE(is.searched, report.enemies);
    shots += is.shots;
    bits += is.bits;
  }
  EXPECT_GT(shots, 0u);
  EXPECT_GT(bits, 0u);
}

TEST(census, of_an_empty_game_is_nobody) {
  const Census census = cpu::makeSimulation(stageConfig())->census();
  EXPECT_EQ(std::count(std::begin(census.enemies), std::end(census.enemies), 0u), kMaxEnemyTypes);
  EXPECT_EQ(census.shots + census.bits + census.searched, 0u);
  EXPECT_EQ(census.misaligned, 0u);
}

// Entities before their predecessor on a row or a column when neighbours were searched: one tick ago every one that is
// still there stood where he was before, in the same cell.
uint32_t misalignedOn(const Snapshot& snapshot, cpu::NDimensions grid) {
  constexpr float kNowhere = std::numeric_limits<float>::infinity();
  struct Stand {
    float x = kNowhere, y = kNowhere;
    uint32_t id = 0;
  };
  std::vector<Stand> byId(grid.cells()), cells;
  for (const EntityRecord& e : snapshot.entities) byId[e.id] = {e.previous_x, e.previous_y, e.id};
  for (uint32_t id : snapshot.arrangement) {
    cells.push_back(byId[id]);
    cells.back().id = id;
  }
  uint32_t count = 0;
  for (uint32_t i = 0; i < cells.size(); ++i) {
    const Stand& c = cells[i];
    if (c.x == kNowhere) continue;
    bool behind = false;
    if (i % grid.columns != 0) {
      const Stand& before = cells[i - 1];
      behind |= std::tie(c.x, c.y, c.id) < std::tie(before.x, before.y, before.id);
    }
    if (i >= grid.columns) {
      const Stand& below = cells[i - grid.columns];
      behind |= std::tie(c.y, c.x, c.id) < std::tie(below.y, below.x, below.id);
    }
    count += behind;
  }
  return count;
}

TEST(census, counts_the_misaligned_of_an_ngrid) {
  SimulationConfig config = stageConfig(1024);
  config.gather = Gather::adaptive;
  config.sort = Sort::oddEven;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, kEnemies));
  uint32_t compared = 0, most = 0;
  for (uint32_t t = 0; t < 120; ++t) {
    simulation->tick({});
    simulation->report();
    const Snapshot snapshot = simulation->snapshot();
    const Census census = simulation->census();
    if (snapshot.entities.size() != census.searched) continue;  // an entity has left since
    ASSERT_EQ(census.misaligned, misalignedOn(snapshot, cpu::dimensionsOf(config))) << "tick " << t;
    most = std::max(most, *census.misaligned);
    ++compared;
  }
  EXPECT_GT(compared, 60u);
  EXPECT_GT(most, 10u);
}

TEST(census, knows_of_the_misaligned_only_where_there_is_an_ngrid) {
  SimulationConfig config = stageConfig(1024);
  for (const BroadPhase broadPhase :
       {BroadPhase::ngrid, BroadPhase::grid, BroadPhase::gridHashed, BroadPhase::bruteForce}) {
    config.broadPhase = broadPhase;
    const auto simulation = cpu::makeSimulation(config);
    simulation->restore(crowdScene(config, kEnemies));
    play(*simulation, 3);
    const Census census = simulation->census();
    EXPECT_EQ(census.searched, kEnemies);
    EXPECT_EQ(census.misaligned.has_value(), broadPhase == BroadPhase::ngrid);
    EXPECT_LE(census.misaligned.value_or(0), census.searched);
  }
}

TEST(census, is_not_felt) {
  const auto plain = cpu::makeSimulation(botConfig()), counted = cpu::makeSimulation(botConfig());
  for (const auto& simulation : {plain.get(), counted.get()}) simulation->restore(crowdScene(botConfig(), kEnemies));
  for (uint32_t t = 0; t < 150; ++t) {
    counted->census();
    plain->tick({});
    counted->tick({});
    ASSERT_EQ(counted->report().hash, plain->report().hash) << "tick " << t;
  }
}

TEST(device_bytes, are_what_the_buffers_hold_and_grow_with_the_game) {
  SimulationConfig config = stageConfig(1024);
  const auto small = cpu::makeSimulation(config);
  config.enemies = 8192;
  const auto large = cpu::makeSimulation(config);
  const size_t perEntity_bytes =
      (large->deviceBytes() - small->deviceBytes()) / (large->capacity() - small->capacity());
  EXPECT_GT(perEntity_bytes, 2 * sizeof(Cell) + sizeof(EntityRecord));
  EXPECT_LT(perEntity_bytes, 1000u);
  const size_t before = small->deviceBytes();
  play(*small, 5);
  small->census();
  small->countCandidates();
  EXPECT_EQ(small->deviceBytes(), before) << "nothing is kept that was needed for a moment";
}

TEST(simulation, keeps_the_config_that_it_was_made_of) {
  SimulationConfig config = botConfig();
  config.seed = 77;
  config.broadPhase = BroadPhase::grid;
  const auto simulation = cpu::makeSimulation(config);
  EXPECT_EQ(simulation->config().seed, 77u);
  EXPECT_EQ(simulation->config().broadPhase, BroadPhase::grid);
  EXPECT_EQ(simulation->config().autopilot, Autopilot::expert);
  EXPECT_EQ(simulation->config().enemies, 1024u);
}

}  // namespace
}  // namespace gw::test
