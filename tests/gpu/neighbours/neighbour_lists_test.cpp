// Stored neighbour lists: what plain host code lists, byte for byte, with every exact search; and what is refused.
#include "gpu/neighbours/neighbour_lists.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "gpu/neighbours/brute_force.h"
#include "gpu/ngrid/ngrid.h"
#include "gpu/ngrid/row_gather.h"
#include "tests/gpu/both_dimensions.h"
#include "tests/gpu/refusal.h"
#include "tests/reference/gpu_oracles.h"

namespace gw::cpu {
namespace {

using test::CellSpec;
using test::In;
using test::Layout;
using test::Lists;
using test::refusal;

std::vector<uint32_t> near(const std::vector<Cell>& cells, const Cell& at, float radius) {
  return naive::neighbours(cells, test::Query{at.x, at.y, radius});
}
std::vector<uint32_t> near(const std::vector<Cell3>& cells, const Cell3& at, float radius) {
  return naive::neighbours(cells, test::Query3{at.x, at.y, at.z, radius});
}

template <class CellT>
Lists listed(const std::vector<CellT>& cells, float radius) {
  Lists lists;
  std::vector<CellT> byId = cells;
  for (const CellT& cell : cells) byId[cell.id] = cell;
  for (const CellT& self : byId) {
    lists.begin.push_back(uint32_t(lists.neighbours.size()));
    if (!isLiving(self.x)) continue;
    for (uint32_t id : near(cells, self, radius)) {
      if (id != self.id) lists.neighbours.push_back(id);
    }
  }
  lists.begin.push_back(uint32_t(lists.neighbours.size()));
  return lists;
}

template <class CellT>
void listsAreThoseOfPlainCode() {
  const uint32_t most = In<CellT>::flat ? 30 : 10;
  const CellSpec spec{
      Layout(*rc::gen::inRange(0u, test::kLayouts)),
      {*rc::gen::inRange(1u, most), *rc::gen::inRange(1u, most), In<CellT>::flat ? 1 : *rc::gen::inRange(1u, most)},
      *rc::gen::element(0u, 10u, 50u, 100u),
      *rc::gen::arbitrary<uint64_t>()};
  const auto cells = In<CellT>::cells(spec);
  const float radius = *rc::gen::element(0.0f, 0.5f, 3.0f, 20.0f, 1e30f);
  const Lists wanted = listed(cells, radius);
  for (test::Method method :
       {test::Method::rows, test::Method::packedRows, test::Method::bruteForce, test::Method::grid}) {
    const Lists got = In<CellT>::lists(probes())({2}, spec.shape, cells, radius, method);
    RC_ASSERT(got.begin == wanted.begin);
    RC_ASSERT(got.neighbours == wanted.neighbours);
  }
}
RC_GTEST_PROP(NeighbourLists, AreThoseOfPlainCode, ()) {
  listsAreThoseOfPlainCode<Cell>();
}
RC_GTEST_PROP(NeighbourLists, AreThoseOfPlainCodeIn3D, ()) {
  listsAreThoseOfPlainCode<Cell3>();
}

TEST(SortIds, SortsShortAndLong) {
  std::mt19937 random(1);
  for (uint32_t count : {0u, 1u, 2u, 47u, 48u, 49u, 50u, 1000u, 4097u}) {
    std::vector<uint32_t> ids(count);
    for (uint32_t& id : ids) id = random() % (count + 1);
    auto wanted = ids;
    std::sort(wanted.begin(), wanted.end());
    sortIds(ids.data(), count);
    EXPECT_EQ(ids, wanted) << count;
    sortIds(ids.data(), count);
    EXPECT_EQ(ids, wanted) << count << ", sorted before";
  }
}

TEST(NeighbourLists, RefuseWhatTheyCannotHoldAndStayAsTheyWere) {
  Queue queue({1});
  Buffer<Cell> cells(queue, 4);
  cells.upload({{0, 0, 0, 0}, {1, 0, 1, 0}, {2, 0, 2, 0}, {3, 0, 3, 0}});
  const BruteForce<Cell> search{cells.data(), 4};
  NeighbourLists lists(queue, 4, 6);
  lists.build(queue, search, cells.data(), 1.0f);
  ASSERT_EQ(lists.total(), 6u);
  const auto words = [&](const uint32_t* d_words, size_t count) {
    return std::vector<uint32_t>(d_words, d_words + count);
  };
  const auto begin = words(lists.begin(), 5), neighbours = words(lists.neighbours(), 6);
  EXPECT_EQ(begin, (std::vector<uint32_t>{0, 1, 3, 5, 6}));
  EXPECT_EQ(neighbours, (std::vector<uint32_t>{1, 0, 2, 1, 3, 2}));
  EXPECT_EQ(refusal<std::length_error>([&] { lists.build(queue, search, cells.data(), 2.0f); }),
            "There are 10 neighbours to list and room for 6; make the lists with a larger capacity.");
  for (float bad : {-1.0f, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    EXPECT_EQ(refusal<std::invalid_argument>([&] {
                lists.build(queue, search, cells.data(), bad);
              }).rfind("The radius of neighbour lists is finite and at least 0 m; it was ", 0),
              0u);
  }
  EXPECT_EQ(
      refusal<std::invalid_argument>([&] { lists.build(queue, search, static_cast<const Cell*>(nullptr), 1.0f); }),
      "d_cells is null; give the cells that are searched.");
  EXPECT_EQ(refusal<std::invalid_argument>([&] { NeighbourLists(queue, 0, 5); }),
            "Neighbour lists are for at least 1 cell; cells was 0.");
  EXPECT_EQ(words(lists.begin(), 5), begin);
  EXPECT_EQ(words(lists.neighbours(), 6), neighbours);
  EXPECT_EQ(lists.total(), 6u);
}

}  // namespace
}  // namespace gw::cpu
