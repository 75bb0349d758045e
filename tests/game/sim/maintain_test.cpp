// What every stage after maintain relies on: each id in one cell, rows in ascending x (or parts of it), the rows'
// intervals and numbers true.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

SimulationConfig configWith(Sort sort) {
  SimulationConfig config = stageConfig();
  config.sort = sort;
  return config;
}

class maintain : public ::testing::TestWithParam<Sort> {
 protected:
  StageFixture fixture{configWith(GetParam())};
  naive::World world = fixture.emptyWorld();

  maintain() { world.globals.tick = kLateTick; }

  // What a row is sorted by.
  float orderOf(const Cell& cell) {
    const cpu::NGridView<Cell>& grid = fixture.view().near.ngrid;
    if (grid.sorted || cell.type == kTypeNone) return cell.x;
    return float(cpu::partOf(grid.totals->parts, grid.parts, cell.x));
  }

  void checkArrangement() {
    const cpu::View& v = fixture.view();
    const auto cells = fixture.state().cells[0].download();
    const auto cellOf = fixture.state().cellOf.download();
    std::vector<uint32_t> seen(cells.size());
    for (uint32_t i = 0; i < cells.size(); ++i) {
      ASSERT_LT(cells[i].id, cells.size());
      EXPECT_EQ(++seen[cells[i].id], 1u) << "id " << cells[i].id << " stands twice";
      EXPECT_EQ(cellOf[cells[i].id], i);
    }
    for (uint32_t row = 0; row < v.near.ngrid.rows; ++row) {
      float low = cpu::kInfinity, high = -cpu::kInfinity;
      uint32_t living = 0;
      for (uint32_t c = 0; c < v.near.ngrid.columns; ++c) {
        const Cell& cell = cells[row * v.near.ngrid.columns + c];
        if (c > 0) {
          EXPECT_LE(orderOf(cells[row * v.near.ngrid.columns + c - 1]), orderOf(cell)) << "row " << row;
        }
        if (cell.type == kTypeNone) continue;
        ++living;
        low = std::min(low, cell.y);
        high = std::max(high, cell.y);
      }
      EXPECT_EQ(v.near.ngrid.living[row], living) << "row " << row;
      EXPECT_EQ(v.near.ngrid.height[row].low, low) << "row " << row;
      EXPECT_EQ(v.near.ngrid.height[row].high, high) << "row " << row;
    }
  }
};

TEST_P(maintain, keeps_the_properties_through_motion_births_and_deaths) {
  Dice dice(1);
  addCrowd(world, 200, 150, 300, 60.0f, dice);
  fixture.put(world);
  uint32_t next = world.entities.back().id + 1;
  for (int tick = 0; tick < 40; ++tick) {
    cpu::maintain(fixture.queue(), fixture.view(), fixture.state().neighbourhood());
    checkArrangement();
    // Between ticks some move, some die and some are born: in place, as spawn and integrate leave them.
    auto cells = fixture.state().cells[0].download();
    for (Cell& cell : cells) {
      if (cell.type == kTypeNone) {
        if (cell.id == next && dice.below(2)) cell = {dice.between(0, 192), dice.between(0, 108), cell.id, kTypeBit};
        continue;
      }
      cell.x += dice.between(-0.5f, 0.5f);
      cell.y += dice.between(-0.5f, 0.5f);
      if (dice.below(60) == 0) cell = {cpu::kInfinity, cpu::kInfinity, cell.id, kTypeNone};
    }
    ++next;
    fixture.state().cells[0].upload(cells);
  }
}

TEST_P(maintain, loses_and_changes_nobody) {
  Dice dice(2);
  addCrowd(world, 250, 200, 400, 50.0f, dice);
  fixture.put(world);
  const auto before = fixture.entities(false, false);
  for (int pass = 0; pass < 5; ++pass) cpu::maintain(fixture.queue(), fixture.view(), fixture.state().neighbourhood());
  EXPECT_TRUE(same(fixture.entities(false, false), before));
}

TEST_P(maintain, everybody_on_one_place_and_nobody_at_all) {
  for (uint32_t i = 0; i < 700; ++i) world.add(bitAt(fixture.rules(), i, 60.0f, 50.0f));
  fixture.put(world);
  for (int pass = 0; pass < 3; ++pass) cpu::maintain(fixture.queue(), fixture.view(), fixture.state().neighbourhood());
  checkArrangement();
  world.entities.clear();
  fixture.put(world);
  cpu::maintain(fixture.queue(), fixture.view(), fixture.state().neighbourhood());
  checkArrangement();
}

std::string nameOf(const testing::TestParamInfo<Sort>& info) {
  return info.param == Sort::bitonic ? "bitonic" : info.param == Sort::full ? "full" : "frozen";
}
INSTANTIATE_TEST_SUITE_P(by, maintain, ::testing::Values(Sort::bitonic, Sort::full, Sort::frozen), nameOf);

}  // namespace
}  // namespace gw::test
