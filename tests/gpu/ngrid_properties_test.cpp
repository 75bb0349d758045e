// The NGrid's properties 1 to 8 (thesis, chapter 4; gpu/ngrid.h), one test each, as far as this version has
// them: dimensions are fixed, and what the windows of 7 and 8 would find is read off the arrangement.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gpu/ngrid.h"
#include "tests/gpu/random_cells.h"
#include "tests/naive/gpu_oracles.h"

namespace gw::test {
namespace {

constexpr GridShape kShape{80, 60};

// An arrangement that has been moved and maintained for a while.
const GridState& usedGrid() {
  static const GridState grid = [] {
    const Probes device = cpu::probes();
    GridState state = device.upkeep({2}, kShape, makeCells({Layout::uniform, kShape, 20, 12}), Upkeep::rebuild);
    for (uint64_t step = 1; step <= 10; ++step) {
      moveCells(state.cells, 0.5f, step);
      state = device.upkeep({2}, kShape, state.cells, Upkeep::maintain);
    }
    return state;
  }();
  return grid;
}

// Living cells only, maintained until nothing moves; how many passes that took.
uint32_t settle(GridState& state) {
  const Probes device = cpu::probes();
  for (uint32_t pass = 1; pass <= 100; ++pass) {
    GridState next = device.upkeep({2}, kShape, state.cells, Upkeep::maintain);
    const bool stable = next.cellOf == state.cellOf;
    state = std::move(next);
    if (stable) return pass;
  }
  return 101;
}

const GridState& settledGrid() {
  static const GridState grid = [] {
    GridState state{makeCells({Layout::uniform, kShape, 0, 13}), {}, {}, {}, {}, {}, {}};
    settle(state);
    return state;
  }();
  return grid;
}

// The share of true neighbours that find(cell) finds, over all cells; it must find no others.
template <class Find>
double recall(const GridState& grid, float radius, const Find& find) {
  uint64_t found = 0, all = 0;
  for (uint32_t i = 0; i < grid.cells.size(); i += 3) {
    if (naive::isDead(grid.cells[i])) continue;
    const auto exact = naive::neighbours(grid.cells, {grid.cells[i].x, grid.cells[i].y, radius});
    const std::vector<uint32_t> window = find(i);
    EXPECT_TRUE(std::includes(exact.begin(), exact.end(), window.begin(), window.end()));
    found += window.size();
    all += exact.size();
  }
  return double(found) / double(all);
}

TEST(NGridProperty1, ThereAreAsManyCellsAsEntities) {
  const GridState& grid = usedGrid();
  std::vector<uint32_t> ids;
  for (const Cell& cell : grid.cells) ids.push_back(cell.id);
  std::sort(ids.begin(), ids.end());
  ASSERT_EQ(ids.size(), kShape.cells());
  for (uint32_t id = 0; id < ids.size(); ++id) ASSERT_EQ(ids[id], id);
}

TEST(NGridProperty2, ACellHoldsOneEntity) {
  const GridState& grid = usedGrid();
  ASSERT_EQ(grid.cellOf.size(), kShape.cells());
  for (uint32_t id = 0; id < grid.cellOf.size(); ++id) {
    ASSERT_LT(grid.cellOf[id], kShape.cells());
    ASSERT_EQ(grid.cells[grid.cellOf[id]].id, id);
  }
}

TEST(NGridProperty3, ACellTakesItsEntitysSize) {
  // Sizes are by type, and the type travels with the entity.
  for (const Cell& cell : usedGrid().cells) ASSERT_EQ(cell.type, 7 * cell.id + 1);
}

TEST(NGridProperty4, ACellTakesItsEntitysPlace) {
  auto cells = usedGrid().cells;
  moveCells(cells, 2.0f, 99);
  const GridState after = cpu::probes().upkeep({2}, kShape, cells, Upkeep::maintain);
  for (const Cell& cell : cells) {
    const Cell& now = after.cells[after.cellOf[cell.id]];
    ASSERT_TRUE(now.x == cell.x && now.y == cell.y) << cell.id;
  }
}

TEST(NGridProperty5, TheNDimensionsMultiplyToN) {
  cpu::Queue queue({1});
  for (uint32_t n : {1u, 1000u, 13312u, 1000000u}) {
    const cpu::NDimensions chosen = cpu::chooseDimensions(n);
    const cpu::NGrid grid(queue, chosen);
    EXPECT_EQ(grid.dimensions().columns * grid.dimensions().rows, chosen.cells());
    EXPECT_EQ(grid.view(nullptr).columns * grid.view(nullptr).rows, chosen.cells());
    EXPECT_GE(chosen.cells(), n);  // what exceeds n is padding by the dead
  }
}

TEST(NGridProperty6, EachLineIsOrderedAlongItsAxis) {
  const auto rowsAscend = [](const GridState& grid) {
    for (uint32_t i = 0; i < kShape.cells(); ++i) {
      if (i % kShape.columns && !(grid.cells[i - 1].x <= grid.cells[i].x)) return false;
    }
    return true;
  };
  const auto disorderInColumns = [](const GridState& grid) {
    uint32_t count = 0;
    for (uint32_t i = kShape.columns; i < kShape.cells(); ++i)
      count += grid.cells[i].y < grid.cells[i - kShape.columns].y;
    return count;
  };
  // Rows after every pass; columns are misaligned by what the row pass moved, until a stable state is reached.
  EXPECT_TRUE(rowsAscend(usedGrid()));
  GridState grid{makeCells({Layout::uniform, kShape, 0, 14}), {}, {}, {}, {}, {}, {}};
  grid = cpu::probes().upkeep({2}, kShape, grid.cells, Upkeep::maintain);
  EXPECT_TRUE(rowsAscend(grid));
  EXPECT_GT(disorderInColumns(grid), 0u);
  EXPECT_LE(settle(grid), 40u);
  EXPECT_TRUE(rowsAscend(grid));
  EXPECT_EQ(disorderInColumns(grid), 0u);
}

TEST(NGridProperty7, OneNRadiusPerAxisReachesTheNeighbours) {
  const GridState& grid = settledGrid();
  constexpr float kRadius = 2.5f;  // about 9 neighbours each
  const auto window = [&](uint32_t columns, uint32_t rows) {
    return recall(grid, kRadius,
                  [&](uint32_t i) { return naive::windowNeighbours(kShape, grid.cells, i, columns, rows, kRadius); });
  };
  // Either axis has its own radius, and both count.
  EXPECT_LT(window(1, 4), 0.9);
  EXPECT_LT(window(4, 1), 0.9);
  EXPECT_GT(window(4, 4), 0.97);
  EXPECT_EQ(window(kShape.columns, kShape.rows), 1.0);
}

TEST(NGridProperty8, TheNRadiusIsFixedOrAdaptive) {
  const GridState& grid = settledGrid();
  for (float radius : {1.0f, 2.5f, 8.0f}) {
    const double fixed =
        recall(grid, radius, [&](uint32_t i) { return naive::windowNeighbours(kShape, grid.cells, i, 4, 4, radius); });
    const double adaptive =
        recall(grid, radius, [&](uint32_t i) { return naive::adaptiveNeighbours(kShape, grid.cells, i, radius); });
    // The adaptive one keeps its recall where a window of four cells no longer reaches.
    EXPECT_GT(adaptive, 0.75) << radius;
    if (radius == 8.0f) {
      EXPECT_GT(adaptive, fixed + 0.2);
    }
  }
}

}  // namespace
}  // namespace gw::test
