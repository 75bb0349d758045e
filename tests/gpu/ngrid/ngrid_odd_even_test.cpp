// Partial odd-even transposition: the passes of its oracle, cell by cell; order never gets worse, and comes by itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "gpu/ngrid/ngrid.h"
#include "gpu/ngrid/row_gather.h"
#include "tests/gpu/both_dimensions.h"
#include "tests/reference/gpu_oracles.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

template <class CellT>
std::vector<uint32_t> idsOf(const std::vector<CellT>& cells) {
  std::vector<uint32_t> ids;
  for (const CellT& cell : cells) ids.push_back(cell.id);
  return ids;
}

template <class CellT>
GridStateOf<CellT> transposed(GridShape shape, const std::vector<CellT>& cells) {
  return In<CellT>::upkeep(kDevice)({2}, shape, cells, Upkeep::transpose);
}

template <class CellT>
class OddEvenOf : public testing::Test {
 public:
  static std::vector<GridShape> shapes() {
    if (In<CellT>::flat) {
      return {{1, 1},   {1, 2},   {2, 1},   {1, 9},    {9, 1},    {2, 2},   {3, 2},
              {16, 16}, {48, 13}, {7, 200}, {130, 40}, {2048, 2}, {2, 2048}};
    }
    return {{1, 1, 1}, {1, 1, 2},   {1, 1, 9},   {2, 2, 2},   {3, 2, 5},
            {9, 8, 7}, {2, 300, 3}, {3, 2, 300}, {300, 1, 2}, {13, 11, 9}};
  }
};
TYPED_TEST_SUITE(OddEvenOf, Dimensions);

TYPED_TEST(OddEvenOf, MakesThePassesOfItsOracle) {
  uint64_t seed = 1;
  for (const GridShape& shape : this->shapes()) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      for (const uint32_t dead : {0u, 30u, 100u}) {
        const CellSpec spec{Layout(layout), shape, dead, ++seed};
        auto cells = In<TypeParam>::cells(spec);
        for (int tick = 0; tick < 3; ++tick) {
          const auto state = transposed(shape, cells);
          ASSERT_EQ(naive::difference(naive::upkeep(shape, cells, Upkeep::transpose), state), "") << spec;
          cells = state.cells;
        }
      }
    }
  }
}

// Pairs of a row or column that stand the wrong way round.
uint64_t inversions(const std::vector<Cell>& line, bool byX) {
  uint64_t count = 0;
  for (size_t i = 0; i < line.size(); ++i) {
    for (size_t j = i + 1; j < line.size(); ++j) {
      std::vector<Cell> pair{line[i], line[j]};
      naive::sortAlong(pair, byX ? 0 : 1);
      count += pair[0].id != line[i].id;
    }
  }
  return count;
}

RC_GTEST_PROP(OddEven, NeverDisordersALineAndPutsItInOrder, ()) {
  const uint32_t n = *rc::gen::inRange(2u, 40u);
  const bool byX = *rc::gen::arbitrary<bool>();
  const GridShape shape = byX ? GridShape{n, 1} : GridShape{1, n};
  auto cells = makeCells({Layout(*rc::gen::inRange(0u, kLayouts)), shape, *rc::gen::element(0u, 30u, 100u),
                          *rc::gen::arbitrary<uint64_t>()});
  uint64_t before = inversions(cells, byX);
  uint32_t calls = 0;
  while (before > 0) {
    cells = transposed(shape, cells).cells;
    const uint64_t after = inversions(cells, byX);
    RC_ASSERT(after < before);
    before = after;
    ++calls;
  }
  RC_ASSERT(calls <= (n + 1) / 2);  // n passes sort n numbers, and a call makes two
}

// The longest way: the first is to be the last.
TEST(OddEven, PutsALineInOrderInAsManyPassesAsItHasCells) {
  for (const uint32_t n : {2u, 3u, 16u, 33u, 500u}) {
    for (const int axis : {0, 1, 2}) {
      const GridShape shape = axis == 0 ? GridShape{n, 1, 1} : axis == 1 ? GridShape{1, n, 1} : GridShape{1, 1, n};
      std::vector<Cell3> line;
      for (uint32_t i = 0; i < n; ++i) {
        const float place = float(n - i);
        line.push_back({axis == 0 ? place : 0.0f, axis == 1 ? place : 0.0f, axis == 2 ? place : 0.0f, i});
      }
      uint32_t calls = 0;
      while (naive::misaligned(shape, line) > 0 && calls <= n) {
        line = transposed(shape, line).cells;
        ++calls;
      }
      EXPECT_LE(calls, (n + 1) / 2) << n << " along axis " << axis;
      EXPECT_GE(calls, n / 2) << "this line is not the longest way";
    }
  }
}

// Every exchange raises the sum of column times x plus row times y: so lines never lose on both axes together
// what they have gained, and repetition comes to an end.
TEST(OddEven, OrderOfAWholeGridOnlyGrowsUntilEveryLineIsInOrder) {
  const GridShape shape{24, 17};
  auto cells = makeCells({Layout::uniform, shape, 0, 8});
  const auto order = [&] {
    double sum = 0;
    for (uint32_t i = 0; i < shape.cells(); ++i) {
      sum += double(i % shape.columns) * double(cells[i].x) + double(i / shape.columns) * double(cells[i].y);
    }
    return sum;
  };
  double before = order();
  uint32_t calls = 0;
  for (bool moving = true; moving && calls < 500; ++calls) {
    const auto ids = idsOf(cells);
    cells = transposed(shape, cells).cells;
    moving = idsOf(cells) != ids;
    const double after = order();
    if (moving) {
      ASSERT_GT(after, before);
    }
    before = after;
  }
  EXPECT_LT(calls, 500u);
  // And what the full line sorts leave alone is what they would have reached.
  EXPECT_EQ(idsOf(kDevice.upkeep({1}, shape, cells, Upkeep::maintain).cells), idsOf(cells));
}

TEST(OddEven, IsLeftAloneWhileOnHoldAsIsTheFullUpkeep) {
  const GridShape shape{20, 11};
  const auto cells = makeCells({Layout::uniform, shape, 20, 5});
  for (const bool full : {false, true}) {
    cpu::Queue queue({2});
    cpu::NGrid<Cell> grid(queue, {shape.columns, shape.rows});
    cpu::Buffer<Cell> held(queue, shape.cells());
    cpu::Buffer<uint32_t> cellOf(queue, shape.cells()), hold(queue, 1);
    held.upload(cells);
    const auto keep = [&](uint32_t word) {
      hold.upload(std::vector<uint32_t>{word});
      full ? grid.maintain(queue, held.data(), cellOf.data(), hold.data())
           : grid.transpose(queue, held.data(), cellOf.data(), hold.data());
      return idsOf(held.download());
    };
    EXPECT_EQ(keep(1), idsOf(cells));
    EXPECT_EQ(keep(7), idsOf(cells));
    EXPECT_NE(keep(0), idsOf(cells));
  }
}

// What is known of the rows stays what belongs to them: exact searches go on finding every neighbour.
TEST(OddEven, OnHoldTheRowsStayKnown) {
  const GridShape shape{60, 20};
  cpu::Queue queue({2});
  cpu::NGrid<Cell> grid(queue, {shape.columns, shape.rows});
  cpu::Buffer<Cell> cells(queue, shape.cells());
  cpu::Buffer<uint32_t> cellOf(queue, shape.cells()), hold(queue, 1);
  auto places = makeCells({Layout::uniform, shape, 10, 6});
  cells.upload(places);
  grid.rebuild(queue, cells.data(), cellOf.data());
  // All but one move far to the left: rows are indexed by what was known before that.
  places = cells.download();
  for (Cell& cell : places) cell.x = cell.id == 5 ? 300.0f : 0.25f * cell.x - 50.0f;
  cells.upload(places);
  grid.maintain(queue, cells.data(), cellOf.data());
  hold.upload(std::vector<uint32_t>{1});
  grid.maintain(queue, cells.data(), cellOf.data(), hold.data());
  const auto arranged = cells.download();
  const cpu::RowGather<Cell> search{grid.view(cells.data())};
  for (const Query& query : makeQueries(arranged, 200, 7)) {
    std::vector<uint32_t> ids;
    search({query.x, query.y}, query.radius, [&](const Cell& cell, uint32_t, Float2) { ids.push_back(cell.id); });
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids, naive::neighbours(arranged, query));
  }
}

}  // namespace
}  // namespace gw::test
