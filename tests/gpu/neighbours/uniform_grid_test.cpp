// The baselines, uniform grid and hashed grid: exact in two and three dimensions, on any data; arranged as plain code
// arranges them; strict about their region and their bins.
#include "gpu/neighbours/uniform_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "gpu/neighbours/hashed_grid.h"
#include "tests/gpu/neighbours/gather_checker.h"
#include "tests/reference/gpu_oracles.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

CellSpec anySpec() {
  return {Layout(*rc::gen::inRange(0u, kLayouts)),
          {*rc::gen::inRange(1u, 70u), *rc::gen::inRange(1u, 70u)},
          *rc::gen::element(0u, 10u, 50u, 95u, 100u),
          *rc::gen::arbitrary<uint64_t>()};
}

RC_GTEST_PROP(UniformGrid, FindsWhatBruteForceFinds, ()) {
  const CellSpec spec = anySpec();
  auto cells = makeCells(spec);
  if (*rc::gen::arbitrary<bool>()) moveCells(cells, 3.0f, spec.seed);
  RC_ASSERT(checkGather(spec.shape, cells, makeQueries(cells, 60, spec.seed + 1), Method::grid) == "");
}

RC_GTEST_PROP(HashedGrid, FindsWhatBruteForceFinds, ()) {
  const CellSpec spec = anySpec();
  const auto cells = makeCells(spec);
  RC_ASSERT(checkGather(spec.shape, cells, makeQueries(cells, 60, spec.seed + 1), Method::hashedGrid) == "");
}

RC_GTEST_PROP(UniformGrid, FindsWhatBruteForceFindsInThreeDimensions, ()) {
  const CellSpec spec = anySpec();
  const auto cells = makeCells3(spec);
  const auto queries = makeQueries3(cells, 30, spec.seed + 1);
  for (const Method method : {Method::bruteForce, Method::grid, Method::hashedGrid}) {
    RC_ASSERT(checkGather(spec.shape, cells, queries, method) == "");
  }
}

TEST(UniformGrid, FindsEveryBoundaryOfEveryLayout) {
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {48, 25}, 10, layout + 1};
    const auto cells = makeCells(spec);
    const auto queries = makeQueries(cells, 1500, layout);
    EXPECT_EQ(checkGather(spec.shape, cells, queries, Method::grid, {2}), "") << spec;
    EXPECT_EQ(checkGather(spec.shape, cells, queries, Method::hashedGrid, {2}), "") << spec;
    const auto high = makeCells3(spec);
    for (const Method method : {Method::grid, Method::hashedGrid}) {
      EXPECT_EQ(checkGather(spec.shape, high, makeQueries3(high, 900, layout), method), "") << spec;
    }
  }
}

// A world of one height is flat: the third dimension changes no neighbour.
TEST(ThreeDimensions, OfOneHeightAreTwo) {
  const CellSpec spec{Layout::uniform, {40, 40}, 10, 77};
  const auto flat = makeCells(spec);
  std::vector<Cell3> level;
  for (const Cell& cell : flat) level.push_back({cell.x, cell.y, cell.x == kInfinite ? kInfinite : 0.0f, cell.id});
  const auto queries = makeQueries(flat, 300, 78);
  std::vector<Query3> same;
  for (const Query& query : queries) same.push_back({query.x, query.y, 0.0f, query.radius});
  EXPECT_EQ(kDevice.gather({1}, spec.shape, flat, queries, Method::grid).found,
            kDevice.gather3({1}, spec.shape, level, same, Method::grid).found);
  for (const Method method : {Method::rows, Method::packedRows, Method::frozenRows}) {
    EXPECT_EQ(kDevice.gather({1}, spec.shape, flat, queries, method).found,
              kDevice.gather3({1}, spec.shape, level, same, method).found);
  }
}

TEST(UniformGrid, NeighboursAroundAndAfterAreThoseOfBruteForce) {
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {31, 17}, 20, layout + 9};
    for (const float radius : {0.5f, 4.0f, 1e30f}) {
      for (const Around method : {Around::grid, Around::hashedGrid}) {
        const auto cells = makeCells(spec);
        const Gathered gathered = kDevice.gatherAround({1}, spec.shape, cells, radius, method);
        const auto arranged = method == Around::grid ? naive::binCells(cells).cells : cells;
        const size_t words = (cells.size() + 31) / 32;
        uint64_t pairs = 0, all = 0;
        for (size_t i = 0; i < arranged.size(); ++i) {
          if (naive::isDead(arranged[i])) continue;
          const auto expected = naive::neighbours(arranged, {arranged[i].x, arranged[i].y, radius});
          std::vector<uint32_t> ids;
          for (uint32_t id = 0; id < cells.size(); ++id) {
            if (gathered.found[i * words + id / 32] >> id % 32 & 1u) ids.push_back(id);
          }
          ASSERT_EQ(ids, expected) << spec << ", radius " << radius << ", cell " << i;
          ASSERT_EQ(gathered.visits[i], expected.size());
          pairs += gathered.tested[i] >> 16;
          all += gathered.tested[i] & 0xFFFFu;
        }
        // Each pair from one side, and none with itself; a run of the grid has up to three tests more.
        EXPECT_LE(double(2 * pairs), (method == Around::grid ? 1.05 : 1.0) * double(all));
      }
    }
  }
}

// What bins that are cut alike hold on each side: the arrangement is that of plain lists.
TEST(UniformGrid, ArrangesAsPlainListsDo) {
  for (const uint32_t count : {1u, 2u, 31u, 1024u, 5000u, 40000u}) {
    for (uint32_t layout = 0; layout < kLayouts; ++layout) {
      const auto cells = makeCells({Layout(layout), {count, 1}, 20, count + layout});
      const Binned mine = kDevice.binCells({2}, cells), wanted = naive::binCells(cells);
      ASSERT_EQ(mine.begin, wanted.begin) << count << ", layout " << layout;
      ASSERT_EQ(mine.cellOf, wanted.cellOf);
      for (size_t i = 0; i < cells.size(); ++i) ASSERT_EQ(mine.cells[i].id, wanted.cells[i].id);
      const Binned hashed = kDevice.hashCells({2}, cells), lists = naive::hashCells(cells);
      ASSERT_EQ(hashed.begin, lists.begin) << count << ", layout " << layout;
      ASSERT_EQ(hashed.cellOf, lists.cellOf);
    }
  }
}

TEST(UniformGrid, TestsFewCandidatesOnSpreadData) {
  const GridShape shape{176, 38};
  const auto cells = makeCells({Layout::uniform, shape, 0, 5});
  std::vector<Query> queries;
  for (const Cell& cell : cells) queries.push_back({cell.x, cell.y, 3.0f});  // about 19 neighbours each
  for (const Method method : {Method::grid, Method::hashedGrid}) {
    const auto tested = kDevice.gather({2}, shape, cells, queries, method).tested;
    EXPECT_LT(std::accumulate(tested.begin(), tested.end(), 0.0), double(cells.size() * cells.size()) / 30);
  }
}

using cpu::binsOver;

TEST(UniformGrid, CoversItsRegionWithBinsOfTheirSize) {
  const auto bins = binsOver(Float2{-10, 5}, Float2{30, 25}, 4.0f, 1000);
  EXPECT_EQ(bins.count[0], 11u);
  EXPECT_EQ(bins.count[1], 6u);
  EXPECT_EQ(bins.count[2], 1u);
  EXPECT_EQ(bins.along(0, -10.0f), 0u);
  EXPECT_EQ(bins.along(0, -6.001f), 0u);
  EXPECT_EQ(bins.along(0, -5.999f), 1u);
  EXPECT_EQ(bins.along(0, -1e30f), 0u);
  EXPECT_EQ(bins.along(0, kInfinite), 10u);
  EXPECT_EQ(bins.along(0, std::nanf("")), 0u);
  EXPECT_EQ(bins.along(1, 25.0f), 5u);
}

TEST(UniformGrid, HasNoMoreBinsThanEntitiesNeed) {
  for (const uint32_t entities : {1u, 100u, 100000u}) {
    const auto bins = binsOver(Float3{0, 0, 0}, Float3{1e6f, 1e6f, 1e6f}, 1e-3f, entities);
    EXPECT_LE(bins.all(), 4 * entities + 64);
    EXPECT_GT(bins.all(), 2 * entities) << "larger than they have to be";
  }
}

TEST(UniformGrid, RefusesWhatIsNoRegionAndNoSize) {
  const float nan = std::nanf("");
  for (const float size : {0.0f, -1.0f, nan, kInfinite}) {
    EXPECT_THROW(binsOver(Float2{0, 0}, Float2{1, 1}, size, 10), std::invalid_argument) << size;
    cpu::Queue queue({1});
    EXPECT_THROW(cpu::HashedGrid<Cell>(queue, 10, size), std::invalid_argument) << size;
  }
  for (const float edge : {-1.0f, nan, kInfinite}) {
    EXPECT_THROW(binsOver(Float2{0, 0}, Float2{1, edge}, 1.0f, 10), std::invalid_argument) << edge;
    EXPECT_THROW(binsOver(Float3{0, 0, 0}, Float3{1, 1, edge}, 1.0f, 10), std::invalid_argument) << edge;
  }
  EXPECT_NO_THROW(binsOver(Float2{3, 3}, Float2{3, 3}, 1.0f, 10)) << "a point is a region";
}

}  // namespace
}  // namespace gw::test
