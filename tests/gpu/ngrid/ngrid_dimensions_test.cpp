// N-dimensions: chosen for exact gathers, for windows, and found by the thesis's way; and what is refused.
#include "gpu/ngrid/ngrid_dimensions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "gpu/ngrid/ngrid.h"
#include "tests/gpu/both_dimensions.h"
#include "tests/gpu/refusal.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::cpu {
namespace {

using test::CellSpec;
using test::GridShape;
using test::In;
using test::Layout;
using test::refusal;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr Float3 kFlatWorld{160.0f, 90.0f, 0.0f};

TEST(ChooseDimensions, HoldsNWithLessThanARowToSpare) {
  for (uint32_t n = 1; n < 4161536; n += n / 50 + 1) {
    const NDimensions found = chooseDimensions(n, kFlatWorld, 4.0f);
    ASSERT_GE(found.cells(), n);
    ASSERT_LT(found.cells() - n, found.columns);
    ASSERT_EQ(found.slabs, 1u);
    ASSERT_LE(found.columns, kLongLine);
    ASSERT_LE(found.rows, kLongLine);
    ASSERT_EQ(found.columns % 32, 16u) << "a stride near a power of two shares cache sets";
  }
}

TEST(ChooseDimensions, HoldsNInSlabsWithLessThanARowOfEachToSpare) {
  for (uint32_t n = 1; n < 20000000; n += n / 7 + 1) {
    const NDimensions found = chooseDimensions(n, {100.0f, 60.0f, 60.0f}, 3.0f);
    ASSERT_GE(found.cells(), n);
    ASSERT_LT(found.cells() - n, found.columns * found.slabs + found.slabs);
  }
}

// Rows about two radii high when about twenty stand within one; higher ones where they stand farther apart.
TEST(ChooseDimensions, MakesRowsSoHighThatTheirEndsCostAsMuchAsTheirMiddles) {
  for (uint32_t n : {8192u, 65536u}) {
    const float height = std::sqrt(float(n) / 0.4f * 9.0f / 16.0f), radius = std::sqrt(20.0f / (0.4f * 3.1416f));
    const NDimensions found = chooseDimensions(n, {height * 16.0f / 9.0f, height, 0.0f}, radius);
    const float rowHeight = height / float(found.rows);
    EXPECT_GT(rowHeight, 1.3f * radius) << n;
    EXPECT_LT(rowHeight, 2.6f * radius) << n;
  }
  // In three dimensions rows are as deep as they are high, near enough.
  const NDimensions deep = chooseDimensions(65536, {80.0f, 45.0f, 45.0f}, 2.3f);
  EXPECT_NEAR(float(deep.rows) / float(deep.slabs), 1.0f, 0.35f);
  // No row is longer.
  EXPECT_EQ(chooseDimensions(4161536, kFlatWorld, 4.0f).columns, 2032u);
}

TEST(ChooseDimensions, TakesLongLinesOnlyForMoreCellsThanOthersHold) {
  for (uint32_t n : {2032u * 2048 + 1, 10000000u, 4080u * 4096}) {
    const NDimensions found = chooseDimensions(n, kFlatWorld, 4.0f);
    EXPECT_GE(found.cells(), n);
    EXPECT_LE(found.columns, kLongestLine);
    EXPECT_LE(found.rows, kLongestLine);
    EXPECT_GT(larger(found.columns, found.rows), kLongLine);
  }
}

TEST(ChooseDimensions, RefusesWhatDoesNotFit) {
  for (uint32_t n : {4080u * 4096 + 1, 100000000u, 4294965264u, 4294967295u}) {
    EXPECT_EQ(refusal([&] { chooseDimensions(n, kFlatWorld, 4.0f); }),
              "An NGrid of " + std::to_string(n) + " cells is too large: at most 16711680 fit; use fewer entities.");
  }
  EXPECT_EQ(refusal([] {
              chooseDimensions(2147483648u, {1, 1, 1}, 1.0f);
            }),
            "An NGrid of 2147483648 cells is too large: at most 2147483647 fit; use fewer entities.");
  EXPECT_EQ(refusal([] { chooseDimensions(0, kFlatWorld, 4.0f); }),
            "An NGrid of 0 cells was asked for; n is at least 1.");
  for (float bad : {0.0f, -1.0f, kInfinite, std::nanf("")}) {
    EXPECT_EQ(refusal([&] { chooseDimensions(10, kFlatWorld, bad); }),
              "A radius to choose dimensions for is finite and above 0 m.");
    if (bad == 0.0f) continue;  // flat_boxes_test.cpp
    for (const Float3 size : {Float3{bad, 1.0f, 0.0f}, {1.0f, bad, 0.0f}, {1.0f, 1.0f, bad}}) {
      const char* refused = "The box of an NGrid has a finite size of at least 0 m along each axis (0 along z: in 2D).";
      EXPECT_EQ(refusal([&] { chooseDimensions(10, size, 1.0f); }), refused);
      EXPECT_EQ(refusal([&] { chooseWindowDimensions(10, size); }), refused);
    }
  }
}

TEST(ChooseWindowDimensions, FollowsTheWorldsAspect) {
  for (const float aspect : {0.1f, 1.0f, 1.7777778f, 10.0f}) {
    for (uint32_t n = 100; n < 2000000; n += n / 3 + 1) {
      const NDimensions d = chooseWindowDimensions(n, {aspect, 1.0f, 0.0f});
      ASSERT_GE(d.cells(), n);
      ASSERT_LT(d.cells() - n, d.columns);
      if (n > 1000 && n < 400000) {  // beyond, the longest line is the limit
        ASSERT_NEAR(float(d.columns) / float(d.rows) / aspect, 1.0f, 0.2f) << n;
      }
    }
  }
  for (uint32_t n = 1000; n < 20000000; n += n / 2) {
    const NDimensions d = chooseWindowDimensions(n, {4.0f, 2.0f, 1.0f});
    ASSERT_GE(d.cells(), n);
    ASSERT_NEAR(float(d.columns) / float(d.rows), 2.0f, 0.4f) << n;
    ASSERT_NEAR(float(d.rows) / float(d.slabs), 2.0f, 0.5f) << n;
  }
  EXPECT_EQ(chooseWindowDimensions(1, {1e-30f, 1.0f, 0.0f}).cells(), 1u);
  EXPECT_EQ(chooseWindowDimensions(5000, {1e-30f, 1.0f, 0.0f}).columns, 3u);
  EXPECT_EQ(chooseWindowDimensions(2048 * 2048, {1e-30f, 1.0f, 0.0f}).columns, kLongLine);
  EXPECT_EQ(chooseWindowDimensions(2048 * 2048 + 1, {1.0f, 1.0f, 0.0f}), (NDimensions{2048, 2049}));
  EXPECT_EQ(chooseWindowDimensions(4096 * 4096, {1e-30f, 1.0f, 0.0f}).columns, kLongestLine);
  for (uint32_t n : {4096u * 4096 + 1, 0xFFFFFFFFu}) {
    EXPECT_EQ(refusal([&] {
                chooseWindowDimensions(n, {1.0f, 1.0f, 0.0f});
              }),
              "An NGrid of " + std::to_string(n) + " cells is too large: at most 16777216 fit; use fewer entities.");
  }
}

TEST(NGridShape, RefusesWhatIsNoGrid) {
  Queue queue({1});
  constexpr uint32_t kMost = 0xFFFFFFFFu;
  for (NDimensions bad : {NDimensions{0, 5},
                          {5, 0},
                          {5, 5, 0},
                          {4097, 1},
                          {1, 4097},
                          {1, 1, 4097},
                          {kMost, 1},
                          {1, kMost},
                          {kMost, kMost},
                          {65536, 65536},
                          {2048, 2048, 512}}) {
    EXPECT_EQ(refusal([&] { NGrid<Cell3>(queue, bad); }),
              "An NGrid has 1 to 4096 columns, rows and slabs, and fewer than 2147483648 cells; it was asked for " +
                  std::to_string(bad.columns) + " x " + std::to_string(bad.rows) + " x " + std::to_string(bad.slabs) +
                  ".");
  }
  EXPECT_EQ(refusal([&] { NGrid<Cell>(queue, {4, 4, 2}); }), "An NGrid in two dimensions has one slab.");
}

template <class CellT>
class FindDimensions : public testing::Test {};
TYPED_TEST_SUITE(FindDimensions, test::Dimensions);

// A world three times as wide as high: whatever the start, steps become equal.
TYPED_TEST(FindDimensions, BalancesTheSteps) {
  using In = test::In<TypeParam>;
  for (const uint32_t n : {700u, 6000u}) {
    auto cells = In::cells({Layout::uniform, {n, 1}, 0, n});
    for (auto& cell : cells) cell.x *= 3.0f;
    Queue queue({2});
    const NDimensions found = findDimensions(queue, cells.data(), n);
    EXPECT_GE(found.cells(), n);
    EXPECT_NEAR(float(found.columns) / float(found.rows), 3.0f, 0.9f);
    // Measured by plain host code on a grid of these dimensions.
    const GridShape shape{found.columns, found.rows, found.slabs};
    const auto settled = naive::upkeep(shape, padded(cells, found), test::Upkeep::sortUntilStable).cells;
    Steps steps{};
    for (int axis = 0; axis < (In::flat ? 2 : 3); ++axis) {
      steps.along[axis] = float(naive::meanStep(shape, settled, axis));
    }
    EXPECT_FALSE(steps.differBy(0.3f)) << steps.along[0] << " " << steps.along[1] << " " << steps.along[2];
  }
}

TYPED_TEST(FindDimensions, TakesWhatHasNoShape) {
  using In = test::In<TypeParam>;
  Queue queue({1});
  for (const Layout layout : {Layout::line, Layout::coincident, Layout::zeros, Layout::clustered}) {
    const auto cells = In::cells({layout, {500, 1}, 10, 3});
    EXPECT_GE(findDimensions(queue, cells.data(), 500).cells(), 500u);
  }
  const auto one = In::cells({Layout::uniform, {1, 1}, 0, 3});
  EXPECT_EQ(findDimensions(queue, one.data(), 1).cells(), 1u);
  EXPECT_EQ(refusal([&] { findDimensions(queue, one.data(), 0); }),
            "An NGrid of 0 cells was asked for; n is at least 1.");
  EXPECT_EQ(refusal([&] { findDimensions(queue, static_cast<const TypeParam*>(nullptr), 5); }),
            "h_cells is null; give the entities to find dimensions for.");
}

TEST(Steps, DifferByAShareOfTheLargest) {
  EXPECT_FALSE((Steps{{1.0f, 0.81f, 0.0f}}.differBy(0.2f)));
  EXPECT_TRUE((Steps{{1.0f, 0.79f, 0.0f}}.differBy(0.2f)));
  EXPECT_TRUE((Steps{{1.0f, 1.0f, 2.0f}}.differBy(0.2f)));
  EXPECT_FALSE((Steps{{0.0f, 0.0f, 3.0f}}.differBy(0.2f)));
  EXPECT_FALSE(Steps{}.differBy(0.2f));
}

// Once more during the run: a crowd that gathers along one axis is to be given other dimensions.
TEST(Steps, SayWhenDimensionsAreToBeFoundAgain) {
  Queue queue({2});
  const NDimensions d{40, 40};
  NGrid<Cell> grid(queue, d);
  Buffer<Cell> cells(queue, d.cells());
  Buffer<uint32_t> cellOf(queue, d.cells());
  auto places = test::makeCells({Layout::uniform, {40, 40}, 0, 8});
  cells.upload(places);
  grid.sortUntilStable(queue, cells.data(), cellOf.data());
  EXPECT_FALSE(grid.steps(queue, cells.data()).differBy(kStepsMayDiffer));
  for (Cell& cell : places) cell.y *= 0.25f;
  cells.upload(places);
  grid.sortUntilStable(queue, cells.data(), cellOf.data());
  const Steps steps = grid.steps(queue, cells.data());
  EXPECT_TRUE(steps.differBy(kStepsMayDiffer));
  const NDimensions next = balancedDimensions(1600, d, steps);
  EXPECT_NEAR(float(next.columns) / float(next.rows), 4.0f, 0.5f);
}

}  // namespace
}  // namespace gw::cpu
