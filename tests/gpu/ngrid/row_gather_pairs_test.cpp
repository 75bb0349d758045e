// Searching only what stands in a later cell finds each pair of neighbours exactly once, by either method,
// for about half the tests.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "gpu/neighbours/brute_force.h"
#include "gpu/ngrid/row_gather.h"
#include "tests/gpu/random_cells.h"

namespace gw::cpu {
namespace {

using Pairs = std::map<std::pair<uint32_t, uint32_t>, int>;  // how often each pair of ids was found

struct Arranged {
  Queue queue{ExecOptions{.threads = 1}};
  NGrid<Cell> grid;
  Buffer<Cell> cells;
  Buffer<uint32_t> cellOf;

  explicit Arranged(const test::CellSpec& spec)
      : grid(queue, {spec.shape.columns, spec.shape.rows}),
        cells(queue, spec.shape.cells()),
        cellOf(queue, spec.shape.cells()) {
    cells.upload(test::makeCells(spec));
    grid.maintain(queue, cells.data(), cellOf.data());
  }
};

template <class Search>
std::pair<Pairs, uint64_t> pairsBy(const Search& search, const std::vector<Cell>& cells, float radius) {
  Pairs pairs;
  uint64_t tested = 0;
  for (uint32_t i = 0; i < cells.size(); ++i) {
    if (!isLiving(cells[i].x)) continue;
    tested += search.after(i, placeOf(cells[i]), radius, [&](const Cell& other, uint32_t index, Float2) {
      EXPECT_GT(index, i);
      EXPECT_EQ(cells[index].id, other.id);
      ++pairs[std::minmax(cells[i].id, other.id)];
    });
  }
  return {pairs, tested};
}

Pairs pairsByDefinition(const std::vector<Cell>& cells, float radius) {
  Pairs pairs;
  for (size_t i = 0; i < cells.size(); ++i) {
    for (size_t j = i + 1; j < cells.size(); ++j) {
      if (!isLiving(cells[i].x) || !isLiving(cells[j].x)) continue;
      if (isNeighbour(placeOf(cells[j]) - placeOf(cells[i]), radius)) pairs[std::minmax(cells[i].id, cells[j].id)] = 1;
    }
  }
  return pairs;
}

TEST(RowGatherPairs, FindsEachPairOnceInEveryLayout) {
  for (uint32_t layout = 0; layout < test::kLayouts; ++layout) {
    for (const float radius : {0.5f, 4.0f, 1.0e30f}) {
      const test::CellSpec spec{test::Layout(layout), {31, 12}, 20, layout + 5};
      SCOPED_TRACE(testing::Message() << spec << " radius " << radius);
      const Arranged arranged(spec);
      const auto cells = arranged.cells.download();
      const Pairs wanted = pairsByDefinition(cells, radius);
      EXPECT_EQ(pairsBy(RowGather{arranged.grid.view(arranged.cells.data())}, cells, radius).first, wanted);
      EXPECT_EQ(pairsBy(BruteForce{arranged.cells.data(), uint32_t(cells.size())}, cells, radius).first, wanted);
    }
  }
}

TEST(RowGatherPairs, NeedsAboutHalfTheTests) {
  const Arranged arranged({test::Layout::uniform, {80, 20}, 0, 3});
  const auto cells = arranged.cells.download();
  const RowGather search{arranged.grid.view(arranged.cells.data())};
  uint64_t both = 0;
  for (const Cell& cell : cells) both += search(placeOf(cell), 6.0f, [](const Cell&, uint32_t, Float2) {});
  const uint64_t once = pairsBy(search, cells, 6.0f).second;
  EXPECT_LT(double(once), 0.55 * double(both));
  EXPECT_GT(double(once), 0.4 * double(both));
}

}  // namespace
}  // namespace gw::cpu
