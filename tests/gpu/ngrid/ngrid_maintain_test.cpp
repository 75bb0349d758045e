// Upkeep of the NGrid against its oracle: the same arrangement cell by cell, and all that is known of the rows.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "tests/gpu/both_dimensions.h"
#include "tests/reference/gpu_oracles.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

constexpr Upkeep kKinds[] = {Upkeep::maintain,        Upkeep::rebuild, Upkeep::refresh,
                             Upkeep::sortUntilStable, Upkeep::pack,    Upkeep::repack};

template <class CellT>
std::string check(GridShape shape, const std::vector<CellT>& cells, Upkeep upkeep, const ExecOptions& options = {2}) {
  return naive::difference(naive::upkeep(shape, cells, upkeep),
                           In<CellT>::upkeep(kDevice)(options, shape, cells, upkeep));
}

template <class CellT>
class NGridUpkeep : public testing::Test {
 public:
  // In three dimensions the rows of the flat shapes come in slabs too.
  static std::vector<GridShape> shapes() {
    std::vector<GridShape> all{{1, 1}, {1, 9}, {9, 1}, {3, 2}, {16, 16}, {48, 13}, {7, 200}, {2048, 2}, {2, 2048}};
    if (In<CellT>::flat) return all;
    for (GridShape more : {GridShape{1, 1, 9}, {4, 3, 2}, {9, 8, 7}, {40, 1, 20}, {1, 30, 20}, {2, 2, 300}}) {
      all.push_back(more);
    }
    return all;
  }
};
TYPED_TEST_SUITE(NGridUpkeep, Dimensions);

TYPED_TEST(NGridUpkeep, ArrangesEveryLayoutAsItsOracle) {
  uint64_t seed = 1;
  for (const GridShape& shape : this->shapes()) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      const CellSpec spec{Layout(layout), shape, layout % 2 * 15, ++seed};
      for (Upkeep upkeep : kKinds) {
        // Hundreds of rounds, of which a plain oracle sorts all lines.
        if (upkeep == Upkeep::sortUntilStable && shape.cells() > 1000) continue;
        EXPECT_EQ(check(shape, In<TypeParam>::cells(spec), upkeep), "") << spec << ", upkeep " << uint32_t(upkeep);
      }
    }
  }
}

TYPED_TEST(NGridUpkeep, ArrangesLinesAsLongAsThereAre) {
  for (const GridShape& shape : {GridShape{4096, 2}, {2, 4096}, {1, 2, 4095}}) {
    if (In<TypeParam>::flat && shape.slabs > 1) continue;
    const auto cells = In<TypeParam>::cells({Layout::uniform, shape, 15, 3});
    for (Upkeep upkeep : {Upkeep::maintain, Upkeep::pack}) {
      EXPECT_EQ(check(shape, cells, upkeep), "") << shape.columns << ", upkeep " << uint32_t(upkeep);
    }
  }
}

TYPED_TEST(NGridUpkeep, FollowsMotionBirthsAndDeaths) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{112, 23} : GridShape{28, 10, 9};
  auto cells = In<TypeParam>::cells({Layout::uniform, shape, 30, 77});
  cells = In<TypeParam>::upkeep(kDevice)({2}, shape, cells, Upkeep::rebuild).cells;
  for (uint64_t step = 1; step <= 40; ++step) {
    moveCells(cells, step % 10 == 0 ? 30.0f : 0.3f, step);
    const Upkeep upkeep = kKinds[step % 6 == 3 ? 0 : step % 6];
    ASSERT_EQ(check(shape, cells, upkeep), "") << "step " << step;
    cells = In<TypeParam>::upkeep(kDevice)({2}, shape, cells, upkeep).cells;
  }
}

TYPED_TEST(NGridUpkeep, IsTheSameOnAnyNumberOfThreadsAndInAnyOrder) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{90, 31} : GridShape{15, 14, 13};
  for (Layout layout : {Layout::uniform, Layout::clustered, Layout::coincident}) {
    const auto cells = In<TypeParam>::cells({layout, shape, 10, 5});
    for (Upkeep upkeep : kKinds) {
      const auto first = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, upkeep);
      for (const ExecOptions& options : {ExecOptions{.threads = 2}, ExecOptions{.threads = 7},
                                         ExecOptions{.threads = 3, .order = VisitOrder::reversed},
                                         ExecOptions{.threads = 2, .order = VisitOrder::shuffled}}) {
        EXPECT_EQ(naive::difference(first, In<TypeParam>::upkeep(kDevice)(options, shape, cells, upkeep)), "");
      }
    }
  }
}

TYPED_TEST(NGridUpkeep, TheFullSortDependsOnTheEntitiesOnly) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{48, 13} : GridShape{9, 8, 7};
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    auto cells = In<TypeParam>::cells({Layout(layout), shape, 10, 9});
    const auto first = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::rebuild);
    std::mt19937_64 random(layout);
    std::shuffle(cells.begin(), cells.end(), random);
    const auto again = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::rebuild);
    EXPECT_EQ(first.cellOf, again.cellOf) << layout;
  }
}

TYPED_TEST(NGridUpkeep, BothFullSortsEndInAnOrderedGrid) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{40, 23} : GridShape{12, 9, 8};
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const auto cells = In<TypeParam>::cells({Layout(layout), shape, layout % 2 * 20, layout});
    // One has every line in order and so moves no more; the other has rows in order, and rows that follow each other.
    const auto settled = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::sortUntilStable);
    EXPECT_EQ(settled.moved, 0u);
    EXPECT_EQ(naive::misaligned(shape, settled.cells), 0u) << layout;
    const auto built = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::rebuild);
    for (uint32_t line = 1; line < shape.lines(); ++line) {
      if (line % shape.rows == 0 || built.living[line] == 0) continue;
      EXPECT_LE(built.high[line - 1], built.low[line]);
    }
    for (uint32_t slab = 1; slab < shape.slabs; ++slab) {
      EXPECT_LE(built.slabReachHigh[slab - 1], built.slabReachLow[slab]);
    }
  }
}

template <class CellT>
void arrangesAnything() {
  const GridShape shape{*rc::gen::inRange(1u, 40u), *rc::gen::inRange(1u, 40u),
                        In<CellT>::flat ? 1 : *rc::gen::inRange(1u, 12u)};
  const CellSpec spec{Layout(*rc::gen::inRange(0u, kLayouts)), shape, *rc::gen::inRange(0u, 101u),
                      *rc::gen::arbitrary<uint64_t>()};
  const auto upkeep = *rc::gen::elementOf(std::vector<Upkeep>(std::begin(kKinds), std::end(kKinds)));
  RC_PRE(upkeep != Upkeep::sortUntilStable || shape.cells() < 600);
  RC_ASSERT(check(shape, In<CellT>::cells(spec), upkeep, {1}) == "");
}
RC_GTEST_PROP(NGridUpkeepOf2, ArrangesAnythingAsItsOracle, ()) {
  arrangesAnything<Cell>();
}
RC_GTEST_PROP(NGridUpkeepOf3, ArrangesAnythingAsItsOracle, ()) {
  arrangesAnything<Cell3>();
}

TEST(NGridUpkeepOf2, IsTheSameInThreeDimensionsWithoutHeight) {
  const GridShape shape{37, 21};
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const auto level = makeCells({Layout(layout), shape, 12, layout});
    std::vector<Cell3> high;
    for (const Cell& cell : level) high.push_back({cell.x, cell.y, naive::isDead(cell) ? cell.x : 0.0f, cell.id});
    for (Upkeep upkeep : kKinds) {
      const GridState flat = kDevice.upkeep({1}, shape, level, upkeep);
      const GridState3 deep = kDevice.upkeep3({1}, shape, high, upkeep);
      EXPECT_EQ(flat.cellOf, deep.cellOf) << layout << ", upkeep " << uint32_t(upkeep);
      EXPECT_EQ(flat.starts, deep.starts);
      EXPECT_EQ(flat.moved, deep.moved);
    }
  }
}

TEST(NGridUpkeepOf2, KnowsRowsWithoutTheLiving) {
  const GridShape shape{16, 8};
  for (Upkeep upkeep : kKinds) {
    const GridState state = kDevice.upkeep({1}, shape, makeCells({Layout::uniform, shape, 100, 1}), upkeep);
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    EXPECT_EQ(state.low, std::vector<float>(8, kInfinite));
    EXPECT_EQ(state.high, std::vector<float>(8, -kInfinite));
    EXPECT_EQ(state.reachLow, std::vector<float>(8, kInfinite));
    EXPECT_EQ(state.reachHigh, std::vector<float>(8, -kInfinite));
    EXPECT_EQ(state.living, std::vector<uint32_t>(8, 0));
  }
}

TEST(NGridUpkeepOf2, FullSortsPutTheDeadIntoTheLastRows) {
  const GridShape shape{48, 13};
  for (Upkeep upkeep : {Upkeep::rebuild, Upkeep::pack}) {
    const GridState state = kDevice.upkeep({1}, shape, makeCells({Layout::clustered, shape, 60, 2}), upkeep);
    for (uint32_t row = 1; row < shape.rows; ++row) EXPECT_LE(state.living[row], state.living[row - 1]);
    EXPECT_EQ(state.living.front(), shape.columns);
    EXPECT_EQ(state.living.back(), 0u);
  }
}

// Rows overlap by a level at most, of which each has 32 on average.
TEST(NGridUpkeepOf2, PackedRowsAreNearlyAsLowAsBuiltOnes) {
  const GridShape shape{176, 38};
  const auto heights = [&](Upkeep upkeep) {
    const GridState state = kDevice.upkeep({2}, shape, makeCells({Layout::uniform, shape, 0, 5}), upkeep);
    float sum = 0;
    for (uint32_t row = 0; row < shape.rows; ++row) sum += state.high[row] - state.low[row];
    return sum;
  };
  EXPECT_LT(heights(Upkeep::pack), 1.06f * heights(Upkeep::rebuild));
}

}  // namespace
}  // namespace gw::test
