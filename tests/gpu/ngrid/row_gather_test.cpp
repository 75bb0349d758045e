// Exact gathering is exact: on any data and however misaligned the columns are, it finds what brute force
// finds. And the judge is sharp: methods with one planted mistake do not get past it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <limits>
#include <numeric>
#include <set>

#include "tests/gpu/both_dimensions.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

template <class CellT>
CellSpec anySpec() {
  const uint32_t slabs = In<CellT>::flat ? 1 : *rc::gen::inRange(1u, 20u);
  const uint32_t most = In<CellT>::flat ? 71 : 17;  // up to 5,000 cells
  return {Layout(*rc::gen::inRange(0u, kLayouts)),
          {*rc::gen::inRange(1u, most), *rc::gen::inRange(1u, most), slabs},
          *rc::gen::element(0u, 10u, 50u, 95u, 100u),
          *rc::gen::arbitrary<uint64_t>()};
}

constexpr Method kByRows[] = {Method::rows, Method::frozenRows, Method::packedRows, Method::builtRows};

// Of cells in no order at all, by every upkeep that exact gathers go with.
template <class CellT>
void findsWhatBruteForceFinds() {
  const CellSpec spec = anySpec<CellT>();
  const auto cells = In<CellT>::cells(spec);
  const auto queries = In<CellT>::queries(cells, 64, spec.seed + 1);
  RC_ASSERT(checkGather(spec.shape, cells, queries, Method::bruteForce) == "");
  for (Method method : kByRows) RC_ASSERT(checkGather(spec.shape, cells, queries, method) == "");
}
RC_GTEST_PROP(RowGather, FindsWhatBruteForceFinds, ()) {
  findsWhatBruteForceFinds<Cell>();
}
RC_GTEST_PROP(RowGather, FindsWhatBruteForceFindsIn3D, ()) {
  findsWhatBruteForceFinds<Cell3>();
}

template <class CellT>
void staysExactAfterMotion() {
  const CellSpec spec = anySpec<CellT>();
  const auto steps = *rc::gen::inRange(1u, 20u);
  const auto step_m = *rc::gen::element(0.01f, 1.0f, 30.0f);
  const auto upkeep = *rc::gen::element(Upkeep::maintain, Upkeep::refresh, Upkeep::pack);
  auto cells = In<CellT>::upkeep(kDevice)({1}, spec.shape, In<CellT>::cells(spec), Upkeep::rebuild).cells;
  for (uint32_t step = 0; step < steps; ++step) {
    moveCells(cells, step_m, spec.seed + step);
    cells = In<CellT>::upkeep(kDevice)({1}, spec.shape, cells, upkeep).cells;
  }
  const auto queries = In<CellT>::queries(cells, 64, spec.seed);
  for (Method method : kByRows) RC_ASSERT(checkGather(spec.shape, cells, queries, method) == "");
}
RC_GTEST_PROP(RowGather, StaysExactAfterMotion, ()) {
  staysExactAfterMotion<Cell>();
}
RC_GTEST_PROP(RowGather, StaysExactAfterMotionIn3D, ()) {
  staysExactAfterMotion<Cell3>();
}

// Every cell looks around itself, and at what comes after it: as brute force does.
template <class CellT>
class LookingAround : public testing::Test {};
TYPED_TEST_SUITE(LookingAround, Dimensions);

TYPED_TEST(LookingAround, FindsWhatBruteForceFinds) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{37, 22} : GridShape{13, 10, 6};
  const auto look = In<TypeParam>::around(kDevice);
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const auto cells = In<TypeParam>::cells({Layout(layout), shape, 15, layout + 40});
    for (const float radius : {0.0f, 0.3f, 5.0f, 40.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
      // By id: they arrange the cells differently.
      const auto byId = [&](Around method) {
        const Gathered gathered = look({2}, shape, cells, radius, method);
        const size_t words = (shape.cells() + 31) / 32;
        std::multiset<std::vector<uint32_t>> sets;
        for (uint32_t i = 0; i < shape.cells(); ++i) {
          if (gathered.visits[i] == 0) continue;
          std::vector<uint32_t> set(gathered.found.begin() + ptrdiff_t(i * words),
                                    gathered.found.begin() + ptrdiff_t((i + 1) * words));
          uint32_t count = 0;
          for (uint32_t word : set) count += uint32_t(std::popcount(word));
          EXPECT_EQ(gathered.visits[i], count);
          sets.insert(set);
        }
        return sets;
      };
      const auto wanted = byId(Around::bruteForce);
      EXPECT_TRUE(byId(Around::rows) == wanted) << layout << ", " << radius;
      EXPECT_TRUE(byId(Around::packedRows) == wanted) << layout << ", " << radius;
    }
  }
}

// The rows that a rebuild made, kept for 200 frames: asked as they stand, without any other upkeep.
template <class CellT>
class FrozenRows : public testing::Test {};
TYPED_TEST_SUITE(FrozenRows, Dimensions);

TYPED_TEST(FrozenRows, StayExact) {
  const GridShape shape = In<TypeParam>::flat ? GridShape{48, 20} : GridShape{20, 7, 6};
  for (const Layout layout : {Layout::uniform, Layout::clustered, Layout::lattice}) {
    auto cells = In<TypeParam>::cells({layout, shape, 10, 3});
    cells = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::rebuild).cells;
    for (uint32_t frame = 0; frame < 200; ++frame) {
      moveCells(cells, 0.4f, frame);
      cells = In<TypeParam>::upkeep(kDevice)({1}, shape, cells, Upkeep::refresh).cells;
      const auto queries = In<TypeParam>::queries(cells, 24, frame);
      ASSERT_EQ(checkGather(shape, cells, queries, Method::frozenRows), "") << frame;
    }
  }
}

TEST(RowGather, FindsEveryBoundaryOfEveryLayout) {
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {48, 25}, 10, layout + 1};
    const auto cells = makeCells(spec);
    for (Method method : kByRows) {
      EXPECT_EQ(checkGather(spec.shape, cells, makeQueries(cells, 1500, layout), method, {2}), "") << spec;
    }
    const CellSpec deep{Layout(layout), {24, 9, 6}, 10, layout + 1};
    const auto high = makeCells3(deep);
    for (Method method : kByRows) {
      EXPECT_EQ(checkGather(deep.shape, high, makeQueries3(high, 1500, layout), method, {2}), "") << deep;
    }
  }
}

TEST(RowGather, FindsNobodyAmongTheDead) {
  const GridShape shape{16, 9};
  const auto cells = makeCells({Layout::uniform, shape, 100, 1});
  const auto gathered = kDevice.gather({1}, shape, cells, {{1, 2, 1e30f}, {0, 0, 1e-30f}}, Method::rows);
  EXPECT_EQ(gathered.visits, std::vector<uint32_t>(2, 0));
  EXPECT_EQ(gathered.tested, std::vector<uint32_t>(2, 0));
}

TEST(RowGather, FindsTheOnlyOneAlive) {
  const GridShape shape{16, 9};
  for (uint32_t id = 0; id < shape.cells(); ++id) {
    auto cells = makeCells({Layout::uniform, shape, 100, 1});
    cells[id].x = 30.0f;
    cells[id].y = 40.0f;
    // Itself; from the origin with the distance exactly 50; and just short of that.
    const std::vector<Query> queries{{30, 40, 0.5f}, {0, 0, 50}, {0, 0, 49.99999f}};
    EXPECT_EQ(checkGather(shape, cells, queries, Method::rows), "");
    const auto gathered = kDevice.gather({1}, shape, cells, queries, Method::rows);
    EXPECT_EQ(gathered.visits, (std::vector<uint32_t>{1, 1, 0}));
  }
}

TEST(RowGather, TestsFewCandidatesOnSpreadData) {
  const GridShape shape{176, 38};
  const auto cells = kDevice.upkeep({2}, shape, makeCells({Layout::uniform, shape, 0, 5}), Upkeep::rebuild).cells;
  std::vector<Query> queries;
  for (const Cell& cell : cells) queries.push_back({cell.x, cell.y, 3.0f});  // about 19 neighbours each
  const auto total = [&](Method method) {
    const auto gathered = kDevice.gather({2}, shape, cells, queries, method);
    const double tested = std::accumulate(gathered.tested.begin(), gathered.tested.end(), 0.0);
    return tested / double(queries.size());
  };
  const double rows = total(Method::rows), packed = total(Method::packedRows), brute = total(Method::bruteForce);
  RecordProperty("tests_per_query", std::to_string(rows));
  RecordProperty("tests_per_query_packed", std::to_string(packed));
  EXPECT_EQ(brute, double(shape.cells()));
  EXPECT_LT(rows, brute / 40);
  EXPECT_LT(packed, brute / 100);
}

// How many of a hundred rounds of random data and queries the judge refuses.
uint32_t refusals(Method method) {
  uint32_t refused = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    const CellSpec spec{Layout(seed % kLayouts), {40, 20}, uint32_t(seed % 5) * 15, seed};
    const auto cells = makeCells(spec);
    refused += checkGather(spec.shape, cells, makeQueries(cells, 60, seed), method) != "";
  }
  return refused;
}

TEST(GatherJudge, AcceptsTheRightMethods) {
  EXPECT_EQ(refusals(Method::rows), 0u);
  EXPECT_EQ(refusals(Method::bruteForce), 0u);
  // What the broken ones are without their mistake: it is the mistake that is caught, nothing else.
  EXPECT_EQ(refusals(Method::noMistake), 0u);
}

TEST(GatherJudge, CatchesPruningByARoundedEdge) {
  EXPECT_GT(refusals(Method::prunesByEdge), 20u);
}
TEST(GatherJudge, CatchesAForgottenRow) {
  EXPECT_GT(refusals(Method::forgetsLastRow), 90u);
}
TEST(GatherJudge, CatchesAMissedBoundary) {
  EXPECT_GT(refusals(Method::stopsBeforeBoundary), 90u);
}
TEST(GatherJudge, CatchesTrustInTheOrderOfRows) {
  EXPECT_GT(refusals(Method::trustsRowOrder), 40u);
}

}  // namespace
}  // namespace gw::test
