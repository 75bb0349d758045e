// What an inexact gather changes in single stages: the hash feels the arrangement, collide bears windows that are not
// symmetric, and a game starts from an arrangement in which few entities stand as well as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

SimulationConfig configWith(Gather gather) {
  SimulationConfig config = stageConfig();
  config.gather = gather;
  return config;
}

uint64_t hashOf(StageFixture& fixture) {
  cpu::hash(fixture.queue(), fixture.view());
  cpu::report(fixture.queue(), fixture.view());
  return fixture.state().report.download()[0].hash;
}

// Puts these ids into the cells from the given places on, in place of those that stand there.
void arrange(StageFixture& fixture, const std::vector<std::pair<uint32_t, uint32_t>>& cellsAndIds) {
  auto cells = fixture.state().cells[0].download();
  for (const auto& [cell, id] : cellsAndIds) {
    const auto at = std::find_if(cells.begin(), cells.end(), [id = id](const Cell& c) { return c.id == id; });
    std::swap(cells[cell], *at);
  }
  std::vector<uint32_t> cellOf(cells.size());
  for (uint32_t i = 0; i < cells.size(); ++i) cellOf[cells[i].id] = i;
  fixture.state().cells[0].upload(cells);
  fixture.state().cellOf.upload(cellOf);
}

TEST(inexact_hash, feels_every_two_cells_that_change_places) {
  for (const Gather gather : {Gather::adaptive, Gather::fixed, Gather::exact}) {
    StageFixture fixture(configWith(gather));
    naive::World world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    Dice dice(3);
    addCrowd(world, 60, 10, 10, 50.0f, dice);
    fixture.begin(world);
    const auto cells = fixture.state().cells[0].download();
    fixture.state().cells[1].upload(cells);
    const auto cellOf = fixture.state().cellOf.download();
    std::set<uint64_t> hashes{hashOf(fixture)};
    uint32_t swaps = 0, ofTheDead = 0;
    for (uint32_t i = 0; i + 1 < cells.size(); i += 97, ++swaps) {
      auto swapped = cells;
      std::swap(swapped[i], swapped[i + 1]);
      ofTheDead += cells[i].type == kTypeNone && cells[i + 1].type == kTypeNone;
      fixture.state().cells[1].upload(swapped);
      auto found = cellOf;
      std::swap(found[cells[i].id], found[cells[i + 1].id]);
      fixture.state().cellOf.upload(found);
      hashes.insert(hashOf(fixture));
    }
    EXPECT_GT(ofTheDead, 10u);
    EXPECT_EQ(hashes.size(), gather == Gather::exact ? 1u : swaps + 1u);
  }
}

// A shot below its victim's left neighbour in the grid, who stands far to the right in the world:
//
//    [far, near in y] [victim]      the shot's window grows up past `far` and right past `high`, to the victim;
//    [shot]           [high]        the victim's stops at `far` and never reaches the shot's column
class asymmetric_window : public ::testing::Test {
 protected:
  static constexpr uint32_t kShot = 0, kHigh = 1, kFar = 2, kVictim = 3;

  // The entities after integrate and collide with that gather.
  static std::vector<EntityRecord> collided(Gather gather) {
    StageFixture fixture(configWith(gather));
    naive::World world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    const Rules& rules = fixture.rules();
    world.add(shotAt(rules, kShot, 50.0f, 50.0f, 0.0f));
    world.add(enemyAt(rules, kHigh, 0, 50.5f, 80.0f));
    world.add(enemyAt(rules, kFar, 0, 90.0f, 50.2f));
    world.add(enemyAt(rules, kVictim, 0, 51.0f, 50.0f));
    fixture.begin(world);
    const uint32_t columns = fixture.state().neighbourhood().dimensions().columns;
    arrange(fixture, {{0, kShot}, {1, kHigh}, {columns, kFar}, {columns + 1, kVictim}});
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    return fixture.entities(true, true);
  }
};

TEST_F(asymmetric_window, a_shot_that_its_victim_does_not_see_flies_on) {
  const Rules& rules = gameRules();
  const auto after = collided(Gather::adaptive);
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[kShot].x, 50.0f + rules.shot.speed_mps * kTick_s);
  EXPECT_EQ(after[kShot].cooldown, 1u);  // hits left
  EXPECT_EQ(after[kShot].target, kNobody);
  EXPECT_EQ(after[kVictim].energy, rules.enemies[0].energy);
  EXPECT_EQ(after[kVictim].flags, 0u);
  EXPECT_EQ(after[kVictim].velocity_x, 0.0f);
}

TEST_F(asymmetric_window, with_a_symmetric_one_it_hits) {
  const auto after = collided(Gather::fixed);
  ASSERT_EQ(after.size(), 3u);  // the shot is spent
  EXPECT_LT(after[kVictim - 1].energy, gameRules().enemies[0].energy);
}

TEST(start_arrangement, holds_every_id_once_and_the_lowest_in_a_corner_of_the_grids_shape) {
  for (const cpu::NDimensions d : {cpu::NDimensions{160, 90}, {1, 7}, {7, 1}, {30, 31}}) {
    const auto ids = cpu::startArrangement(d);
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), size_t(d.cells()));
    EXPECT_EQ(*std::max_element(ids.begin(), ids.end()), d.cells() - 1);
    const uint32_t quarter = d.cells() / 4;
    for (uint32_t cell = 0; cell < d.cells(); ++cell) {
      if (ids[cell] >= quarter) continue;
      EXPECT_LE(cell % d.columns, d.columns / 2) << d.columns;
      EXPECT_LE(cell / d.columns, d.rows / 2) << d.columns;
    }
  }
}

TEST(start_arrangement, upkeep_of_empty_cells_leaves_it) {
  for (const Sort sort : {Sort::bitonic, Sort::oddEven}) {
    SimulationConfig config = configWith(Gather::adaptive);
    config.sort = sort;
    StageFixture fixture(config);
    const auto idsOf = [&] {
      std::vector<uint32_t> ids;
      for (const Cell& cell : fixture.state().cells[0].download()) ids.push_back(cell.id);
      return ids;
    };
    EXPECT_EQ(idsOf(), cpu::startArrangement(fixture.state().neighbourhood().dimensions()));
    cpu::maintain(fixture.queue(), fixture.view(), fixture.state().neighbourhood());
    EXPECT_EQ(idsOf(), cpu::startArrangement(fixture.state().neighbourhood().dimensions()));
  }
}

}  // namespace
}  // namespace gw::test
