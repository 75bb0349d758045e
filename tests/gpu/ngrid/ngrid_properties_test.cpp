// The NGrid's properties 1 to 8 (thesis, chapter 4; gpu/ngrid/ngrid.h), one test each, in two and three dimensions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gpu/ngrid/ngrid.h"
#include "tests/gpu/both_dimensions.h"
#include "tests/reference/gpu_oracles.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

template <class CellT>
constexpr GridShape kShape = In<CellT>::flat ? GridShape{80, 60, 1} : GridShape{20, 18, 15};

// An arrangement that has been moved and maintained for a while.
template <class CellT>
const GridStateOf<CellT>& usedGrid() {
  static const GridStateOf<CellT> grid = [] {
    const auto upkeep = In<CellT>::upkeep(kDevice);
    auto cells = In<CellT>::cells({Layout::uniform, kShape<CellT>, 20, 12});
    auto state = upkeep({2}, kShape<CellT>, cells, Upkeep::rebuild);
    for (uint64_t step = 1; step <= 10; ++step) {
      moveCells(state.cells, 0.5f, step);
      state = upkeep({2}, kShape<CellT>, state.cells, Upkeep::maintain);
    }
    return state;
  }();
  return grid;
}

// Living cells only, maintained until nothing moves.
template <class CellT>
const GridStateOf<CellT>& settledGrid() {
  static const GridStateOf<CellT> grid = In<CellT>::upkeep(kDevice)(
      {2}, kShape<CellT>, In<CellT>::cells({Layout::uniform, kShape<CellT>, 0, 13}), Upkeep::sortUntilStable);
  return grid;
}

std::vector<uint32_t> exactNeighbours(const std::vector<Cell>& cells, uint32_t i, float radius) {
  return naive::neighbours(cells, Query{cells[i].x, cells[i].y, radius});
}
std::vector<uint32_t> exactNeighbours(const std::vector<Cell3>& cells, uint32_t i, float radius) {
  return naive::neighbours(cells, Query3{cells[i].x, cells[i].y, cells[i].z, radius});
}

// The share of true neighbours that find(cell) finds, over some cells; it must find no others.
template <class CellT, class Find>
double recall(const GridStateOf<CellT>& grid, float radius, const Find& find) {
  uint64_t found = 0, all = 0;
  for (uint32_t i = 0; i < grid.cells.size(); i += 3) {
    const auto exact = exactNeighbours(grid.cells, i, radius);
    const std::vector<uint32_t> window = find(i);
    EXPECT_TRUE(std::includes(exact.begin(), exact.end(), window.begin(), window.end()));
    found += window.size();
    all += exact.size();
  }
  return double(found) / double(all);
}

// As many as there are living cells whose predecessor on a line of the axis stands behind them.
template <class CellT>
uint32_t disorder(const GridStateOf<CellT>& grid, int axis) {
  const GridShape shape = kShape<CellT>;
  const uint32_t stride = axis == 0 ? 1 : axis == 1 ? shape.columns : shape.columns * shape.rows;
  const uint32_t length = axis == 0 ? shape.columns : axis == 1 ? shape.rows : shape.slabs;
  uint32_t count = 0;
  for (uint32_t i = 0; i < grid.cells.size(); ++i) {
    if (i / stride % length == 0) continue;
    count += In<CellT>::along(grid.cells[i], axis) < In<CellT>::along(grid.cells[i - stride], axis);
  }
  return count;
}

template <class CellT>
class NGridProperty : public testing::Test {};
TYPED_TEST_SUITE(NGridProperty, Dimensions);

TYPED_TEST(NGridProperty, Number1ThereAreAsManyCellsAsEntities) {
  std::vector<uint32_t> ids;
  for (const auto& cell : usedGrid<TypeParam>().cells) ids.push_back(cell.id);
  std::sort(ids.begin(), ids.end());
  ASSERT_EQ(ids.size(), kShape<TypeParam>.cells());
  for (uint32_t id = 0; id < ids.size(); ++id) ASSERT_EQ(ids[id], id);
}

TYPED_TEST(NGridProperty, Number2ACellHoldsOneEntity) {
  const auto& grid = usedGrid<TypeParam>();
  ASSERT_EQ(grid.cellOf.size(), kShape<TypeParam>.cells());
  for (uint32_t id = 0; id < grid.cellOf.size(); ++id) {
    ASSERT_LT(grid.cellOf[id], grid.cells.size());
    ASSERT_EQ(grid.cells[grid.cellOf[id]].id, id);
  }
}

TEST(NGridPropertyOf2, Number3ACellTakesItsEntitysSize) {
  // Sizes are by type, and the type travels with the entity.
  for (const Cell& cell : usedGrid<Cell>().cells) ASSERT_EQ(cell.type, 7 * cell.id + 1);
}

TYPED_TEST(NGridProperty, Number4ACellTakesItsEntitysPlace) {
  auto cells = usedGrid<TypeParam>().cells;
  moveCells(cells, 2.0f, 99);
  for (Upkeep upkeep : {Upkeep::maintain, Upkeep::transpose, Upkeep::refresh, Upkeep::pack, Upkeep::sortUntilStable}) {
    const auto after = In<TypeParam>::upkeep(kDevice)({2}, kShape<TypeParam>, cells, upkeep);
    for (const auto& cell : cells) {
      const auto& now = after.cells[after.cellOf[cell.id]];
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(In<TypeParam>::along(now, axis), In<TypeParam>::along(cell, axis)) << cell.id;
      }
    }
  }
}

TYPED_TEST(NGridProperty, Number5TheNDimensionsMultiplyToN) {
  cpu::Queue queue({1});
  for (uint32_t n : {1u, 1000u, 13312u, 1000000u}) {
    const cpu::NDimensions chosen = cpu::chooseDimensions(n, {160.0f, 90.0f, In<TypeParam>::flat ? 0.0f : 40.0f}, 4.0f);
    const cpu::NGrid<TypeParam> grid(queue, chosen);
    const auto view = grid.view(nullptr);
    EXPECT_EQ(view.columns * view.rows * view.slabs, chosen.cells());
    EXPECT_EQ(grid.dimensions(), chosen);
    EXPECT_GE(chosen.cells(), n);  // what exceeds n is padding by the dead
  }
}

TYPED_TEST(NGridProperty, Number6EachLineIsOrderedAlongItsAxis) {
  // Rows after every pass; other lines are misaligned by what later passes moved, until nothing moves.
  EXPECT_EQ(disorder(usedGrid<TypeParam>(), 0), 0u);
  const auto start = In<TypeParam>::cells({Layout::uniform, kShape<TypeParam>, 0, 14});
  const auto once = In<TypeParam>::upkeep(kDevice)({2}, kShape<TypeParam>, start, Upkeep::maintain);
  EXPECT_EQ(disorder(once, 0), 0u);
  EXPECT_GT(disorder(once, 1), 0u);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(disorder(settledGrid<TypeParam>(), axis), 0u);
}

TYPED_TEST(NGridProperty, Number7OneNRadiusPerAxisReachesTheNeighbours) {
  const auto& grid = settledGrid<TypeParam>();
  const bool flat = In<TypeParam>::flat;
  const float radius = flat ? 2.5f : 7.0f;  // about 9 neighbours each
  const auto window = [&](uint32_t x, uint32_t y, uint32_t z) {
    const uint32_t away[3] = {x, y, z};
    return recall(grid, radius,
                  [&](uint32_t i) { return naive::windowNeighbours(kShape<TypeParam>, grid.cells, i, away, radius); });
  };
  // Each axis has its own radius, and all count.
  const double all = window(4, 4, 4);
  EXPECT_GT(all, flat ? 0.97 : 0.9);
  EXPECT_LT(window(1, 4, 4), all - 0.05);
  EXPECT_LT(window(4, 1, 4), all - 0.05);
  if (!flat) {
    EXPECT_LT(window(4, 4, 1), all - 0.05);
  }
  EXPECT_EQ(window(1000, 1000, 1000), 1.0);
}

TYPED_TEST(NGridProperty, Number8TheNRadiusIsFixedOrAdaptive) {
  const auto& grid = settledGrid<TypeParam>();
  const uint32_t away[3] = {4, 4, 4};
  const bool flat = In<TypeParam>::flat;
  const float far = flat ? 8.0f : 45.0f;
  for (float radius : {flat ? 1.0f : 5.0f, flat ? 2.5f : 9.0f, far}) {
    const double fixed = recall(grid, radius, [&](uint32_t i) {
      return naive::windowNeighbours(kShape<TypeParam>, grid.cells, i, away, radius);
    });
    const double adaptive = recall(
        grid, radius, [&](uint32_t i) { return naive::adaptiveNeighbours(kShape<TypeParam>, grid.cells, i, radius); });
    this->RecordProperty("adaptive_recall_" + std::to_string(radius), std::to_string(adaptive));
    // The adaptive one keeps its recall where a window of four cells no longer reaches.
    EXPECT_GT(adaptive, flat ? 0.75 : 0.6) << radius;
    if (radius == far) {
      EXPECT_GT(adaptive, fixed + 0.2);
    }
  }
}

}  // namespace
}  // namespace gw::test
