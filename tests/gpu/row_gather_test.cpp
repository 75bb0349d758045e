// Exact gathering is exact: on any data and however misaligned the columns are, it finds what brute force
// finds. And the judge is sharp: methods with one planted mistake do not get past it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "tests/gpu/gather_checker.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

CellSpec anySpec() {
  return {Layout(*rc::gen::inRange(0u, kLayouts)),
          {*rc::gen::inRange(1u, 50u), *rc::gen::inRange(1u, 50u)},
          *rc::gen::element(0u, 10u, 50u, 95u, 100u),
          *rc::gen::arbitrary<uint64_t>()};
}

RC_GTEST_PROP(RowGather, FindsWhatBruteForceFinds, ()) {
  const CellSpec spec = anySpec();
  const auto cells = makeCells(spec);
  const auto queries = makeQueries(cells, 60, spec.seed + 1);
  RC_ASSERT(checkGather(spec.shape, cells, queries, Method::bruteForce) == "");
  RC_ASSERT(checkGather(spec.shape, cells, queries, Method::rows) == "");
}

RC_GTEST_PROP(RowGather, StaysExactAfterMotion, ()) {
  const CellSpec spec = anySpec();
  const auto steps = *rc::gen::inRange(1u, 20u);
  const auto step_m = *rc::gen::element(0.01f, 1.0f, 30.0f);
  auto cells = kDevice.upkeep({1}, spec.shape, makeCells(spec), Upkeep::rebuild).cells;
  for (uint32_t step = 0; step < steps; ++step) {
    moveCells(cells, step_m, spec.seed + step);
    cells = kDevice.upkeep({1}, spec.shape, cells, Upkeep::maintain).cells;
  }
  RC_ASSERT(checkGather(spec.shape, cells, makeQueries(cells, 60, spec.seed), Method::rows) == "");
}

// The rows that a rebuild made, kept for 200 frames.
TEST(RowGather, StaysExactOverFrozenRows) {
  for (const Layout layout : {Layout::uniform, Layout::clustered, Layout::lattice}) {
    const CellSpec spec{layout, {48, 20}, 10, 3};
    auto cells = kDevice.upkeep({1}, spec.shape, makeCells(spec), Upkeep::rebuild).cells;
    for (uint32_t frame = 0; frame < 200; ++frame) {
      moveCells(cells, 0.4f, frame);
      cells = kDevice.upkeep({1}, spec.shape, cells, Upkeep::refresh).cells;
      // As they stand: asked by rows without any other upkeep.
      ASSERT_EQ(checkGather(spec.shape, cells, makeQueries(cells, 20, frame), Method::frozenRows), "") << frame;
    }
  }
}

TEST(RowGather, FindsEveryBoundaryOfEveryLayout) {
  for (uint32_t layout = 0; layout < kLayouts; ++layout) {
    const CellSpec spec{Layout(layout), {48, 25}, 10, layout + 1};
    const auto cells = makeCells(spec);
    EXPECT_EQ(checkGather(spec.shape, cells, makeQueries(cells, 1500, layout), Method::rows, {2}), "") << spec;
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
  const double rows = total(Method::rows), brute = total(Method::bruteForce);
  RecordProperty("tests_per_query", std::to_string(rows));
  EXPECT_EQ(brute, double(shape.cells()));
  EXPECT_LT(rows, brute / 40);
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
