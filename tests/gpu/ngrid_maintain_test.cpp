// Upkeep of the NGrid against its oracle: the same arrangement cell by cell, and all that is known of the rows.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>

#include "gpu/ngrid.h"
#include "tests/gpu/random_cells.h"
#include "tests/naive/gpu_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

// The first thing in which the two differ; empty when they are the same.
std::string difference(const GridState& expected, const GridState& actual) {
  for (size_t i = 0; i < expected.cells.size(); ++i) {
    const Cell &mine = expected.cells[i], &theirs = actual.cells[i];
    if (mine.id != theirs.id) {
      return "cell " + std::to_string(i) + " holds " + std::to_string(theirs.id) + " instead of " +
             std::to_string(mine.id);
    }
    if (mine.x != theirs.x || mine.y != theirs.y || mine.type != theirs.type) {
      return "entity " + std::to_string(mine.id) + " has changed";
    }
  }
  if (expected.cellOf != actual.cellOf) return "cellOf is not the inverse";
  if (expected.living != actual.living) return "the living are miscounted";
  if (expected.low != actual.low || expected.high != actual.high) return "an interval is wrong";
  if (expected.reachLow != actual.reachLow || expected.reachHigh != actual.reachHigh) return "a reach is wrong";
  return "";
}

constexpr GridShape kShapes[] = {{1, 1},   {1, 9},    {9, 1},   {3, 2},    {16, 16},
                                 {48, 13}, {112, 65}, {7, 200}, {2048, 2}, {2, 2048}};

TEST(NGridUpkeep, ArrangesEveryLayoutAsItsOracle) {
  uint64_t seed = 1;
  for (const GridShape& shape : kShapes) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      const CellSpec spec{Layout(layout), shape, layout % 2 * 15, ++seed};
      for (Upkeep upkeep : {Upkeep::maintain, Upkeep::rebuild, Upkeep::refresh}) {
        const auto cells = makeCells(spec);
        EXPECT_EQ(difference(naive::upkeep(shape, cells, upkeep), kDevice.upkeep({2}, shape, cells, upkeep)), "")
            << spec;
      }
    }
  }
}

TEST(NGridUpkeep, FollowsMotionBirthsAndDeaths) {
  const GridShape shape{112, 23};
  GridState state{makeCells({Layout::uniform, shape, 30, 77}), {}, {}, {}, {}, {}, {}};
  state = kDevice.upkeep({2}, shape, state.cells, Upkeep::rebuild);
  for (uint64_t step = 1; step <= 40; ++step) {
    moveCells(state.cells, step % 10 == 0 ? 30.0f : 0.3f, step);
    const GridState expected = naive::upkeep(shape, state.cells, Upkeep::maintain);
    state = kDevice.upkeep({2}, shape, state.cells, Upkeep::maintain);
    ASSERT_EQ(difference(expected, state), "") << "step " << step;
  }
}

TEST(NGridUpkeep, KnowsRowsWithoutTheLiving) {
  const GridShape shape{16, 8};
  const GridState state = kDevice.upkeep({1}, shape, makeCells({Layout::uniform, shape, 100, 1}), Upkeep::rebuild);
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(state.low, std::vector<float>(8, kInfinite));
  EXPECT_EQ(state.high, std::vector<float>(8, -kInfinite));
  EXPECT_EQ(state.reachLow, std::vector<float>(8, kInfinite));
  EXPECT_EQ(state.reachHigh, std::vector<float>(8, -kInfinite));
  EXPECT_EQ(state.living, std::vector<uint32_t>(8, 0));
}

TEST(NGridUpkeep, ARebuildPutsTheDeadIntoTheLastRows) {
  const GridShape shape{48, 13};
  const GridState state = kDevice.upkeep({1}, shape, makeCells({Layout::clustered, shape, 60, 2}), Upkeep::rebuild);
  for (uint32_t row = 1; row < shape.rows; ++row) EXPECT_LE(state.living[row], state.living[row - 1]);
  EXPECT_EQ(state.living.front(), shape.columns);
  EXPECT_EQ(state.living.back(), 0u);
}

RC_GTEST_PROP(NGridUpkeep, ArrangesAnythingAsItsOracle, ()) {
  const GridShape shape{*rc::gen::inRange(1u, 60u), *rc::gen::inRange(1u, 60u)};
  const CellSpec spec{Layout(*rc::gen::inRange(0u, kLayouts)), shape, *rc::gen::inRange(0u, 101u),
                      *rc::gen::arbitrary<uint64_t>()};
  const auto upkeep = Upkeep(*rc::gen::inRange(0u, 2u));
  const auto cells = makeCells(spec);
  const std::string found = difference(naive::upkeep(shape, cells, upkeep), kDevice.upkeep({1}, shape, cells, upkeep));
  RC_ASSERT(found == "");
}

TEST(ChooseDimensions, HoldsNWithLessThanARowToSpare) {
  for (uint32_t n = 1; n < 4161536; n += n / 50 + 1) {
    const cpu::NDimensions found = cpu::chooseDimensions(n);
    ASSERT_GE(found.cells(), n);
    ASSERT_LT(found.cells() - n, found.columns);
    ASSERT_LE(found.columns, cpu::kLongestLine);
    ASSERT_LE(found.rows, cpu::kLongestLine);
    ASSERT_EQ(found.columns % 32, 16u) << "a stride near a power of two shares cache sets";
  }
}

TEST(ChooseDimensions, MakesRowsAboutTwentyFourTimesAsLongAsColumns) {
  for (uint32_t n : {5000u, 13312u, 65536u, 150000u}) {
    const cpu::NDimensions found = cpu::chooseDimensions(n);
    EXPECT_NEAR(double(found.columns) / found.rows, 24.0, 3.0) << n;
  }
  EXPECT_EQ(cpu::chooseDimensions(1000000).columns, 2032u);  // no row is longer
}

TEST(ChooseDimensions, TakesNothingAndTheMost) {
  EXPECT_EQ(cpu::chooseDimensions(0).rows, 1u);
  EXPECT_EQ(cpu::chooseDimensions(2032 * 2048).cells(), 2032u * 2048);
}

TEST(ChooseDimensions, RefusesWhatDoesNotFit) {
  for (uint32_t n : {2032u * 2048 + 1, 10000000u, 4294965264u, 4294967295u}) {
    try {
      const cpu::NDimensions found = cpu::chooseDimensions(n);
      ADD_FAILURE() << n << " cells in " << found.columns << " x " << found.rows;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()),
                "An NGrid of " + std::to_string(n) + " cells is too large: at most 4161536 fit; use fewer entities.");
    }
  }
}

TEST(NGridShape, RefusesEmptyAndOverlongLines) {
  cpu::Queue queue({1});
  constexpr uint32_t kMost = 0xFFFFFFFFu;
  for (cpu::NDimensions bad : {cpu::NDimensions{0, 5},
                               {5, 0},
                               {0, 0},
                               {2049, 1},
                               {1, 2049},
                               {kMost, 1},
                               {1, kMost},
                               {kMost, kMost},
                               {65536, 65536}}) {
    EXPECT_THROW(cpu::NGrid(queue, bad), std::invalid_argument) << bad.columns << " x " << bad.rows;
  }
}

}  // namespace
}  // namespace gw::test
