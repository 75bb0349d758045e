// Sorting one line: the unique order by one axis, then the others, then the id.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/gpu/random_cells.h"
#include "tests/reference/gpu_oracles.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

// By bits: +0 and -0 are the same place, but a cell that had one must keep it.
bool sameCells(const std::vector<Cell>& a, const std::vector<Cell>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Cell& one, const Cell& other) {
           return std::signbit(one.x) == std::signbit(other.x) && std::signbit(one.y) == std::signbit(other.y) &&
                  one.x == other.x && one.y == other.y && one.id == other.id && one.type == other.type;
         });
}

void expectSorted(std::vector<Cell> line) {
  auto byX = line, byY = line;
  naive::sortAlong(byX, 0);
  naive::sortAlong(byY, 1);
  EXPECT_TRUE(sameCells(kDevice.sortLineByX({1}, line), byX));
  EXPECT_TRUE(sameCells(kDevice.sortLineByY({1}, line), byY));
}

TEST(LineSort, SortsEveryLengthAndLayout) {
  for (uint32_t length : {1u, 2u, 3u, 5u, 64u, 100u, 1023u, 1024u, 2047u, 2048u, 2049u, 4095u, 4096u}) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      SCOPED_TRACE(length);
      expectSorted(makeCells({Layout(layout), {length, 1}, layout % 3 * 20, length + layout}));
    }
  }
}

TEST(LineSort, SortsWhatIsNearlySortedAndWhatIsBackwards) {
  auto line = makeCells({Layout::uniform, {2000, 1}, 5, 4});
  naive::sortAlong(line, 0);
  moveCells(line, 0.2f, 5);
  expectSorted(line);
  naive::sortAlong(line, 0);
  expectSorted(line);
  std::reverse(line.begin(), line.end());
  expectSorted(line);
}

TEST(LineSort, SortsPolesByZThenYThenX) {
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    auto expected = makeCells3({Layout(layout), {300, 1}, 15, layout});
    const auto sorted = kDevice.sortLineByZ({1}, expected);
    naive::sortAlong(expected, 2);
    for (size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(sorted[i].id, expected[i].id) << layout;
  }
}

TEST(LineSort, GroupsTheDeadAtTheEndById) {
  for (const auto& cells :
       {makeCells({Layout::uniform, {500, 1}, 50, 6}), makeCells({Layout::line, {500, 1}, 100, 6})}) {
    for (const auto& sorted : {kDevice.sortLineByX({1}, cells), kDevice.sortLineByY({1}, cells)}) {
      const auto dead = std::find_if(sorted.begin(), sorted.end(), naive::isDead);
      EXPECT_TRUE(std::all_of(dead, sorted.end(), naive::isDead));
      EXPECT_TRUE(std::is_sorted(dead, sorted.end(), [](const Cell& a, const Cell& b) { return a.id < b.id; }));
    }
  }
}

RC_GTEST_PROP(LineSort, IsThatOfTheStandardLibraryForAnything, ()) {
  const CellSpec spec{Layout(*rc::gen::inRange(0u, kLayouts)),
                      {*rc::gen::inRange(1u, 700u), 1},
                      *rc::gen::inRange(0u, 101u),
                      *rc::gen::arbitrary<uint64_t>()};
  auto expected = makeCells(spec);
  const auto sorted = kDevice.sortLineByX({1}, expected);
  naive::sortAlong(expected, 0);
  RC_ASSERT(sameCells(sorted, expected));
}

}  // namespace
}  // namespace gw::test
