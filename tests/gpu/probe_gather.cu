#include "gpu/brute_force.h"
#include "gpu/row_gather.h"
#include "gpu/window_gather.h"
#include "tests/gpu/broken_gather.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one query.
template <class Search>
struct Find {
  uint32_t *found, *visits, *tested;
  const test::Query* queries;
  const uint32_t* cellOf;
  Search search;
  uint32_t wordsPerQuery;

  GW_BODY void operator()(uint32_t i) const {
    const test::Query& q = queries[i];
    uint32_t* mine = found + i * wordsPerQuery;
    uint32_t count = 0;
    tested[i] = search(q.x, q.y, q.radius, [&](const Cell& cell, uint32_t index, float dx, float dy) {
      mine[cell.id / 32] |= 1u << cell.id % 32;
      // A visit whose index or difference is wrong counts a thousandfold, which no right answer does.
      const bool right = cellOf[cell.id] == index && dx == cell.x - q.x && dy == cell.y - q.y;
      count += right ? 1 : 1000000;
    });
    visits[i] = count;
  }
};

test::Gathered gather(const ExecOptions& options, test::GridShape shape, const std::vector<Cell>& start,
                      const std::vector<test::Query>& queries, test::Method method) {
  Queue queue(options);
  NGrid grid(queue, {shape.columns, shape.rows});
  auto cells = uploaded(queue, start);
  auto asked = uploaded(queue, queries);
  const uint32_t n = uint32_t(queries.size()), words = (shape.cells() + 31) / 32;
  Buffer<uint32_t> cellOf(queue, start.size()), found(queue, n * words), visits(queue, n), tested(queue, n);
  grid.maintain(queue, cells.data(), cellOf.data());

  const auto run = [&](auto search) {
    forEach(
        queue, Count{n},
        Find<decltype(search)>{found.data(), visits.data(), tested.data(), asked.data(), cellOf.data(), search, words});
  };
  const NGridView view = grid.view(cells.data());
  using test::Method;
  switch (method) {
    case Method::rows:
      run(RowGather{view});
      break;
    case Method::bruteForce:
      run(BruteForce{cells.data(), shape.cells()});
      break;
    case Method::noMistake:
      run(BrokenGather<Method::noMistake>{view});
      break;
    case Method::prunesByEdge:
      run(BrokenGather<Method::prunesByEdge>{view});
      break;
    case Method::forgetsLastRow:
      run(BrokenGather<Method::forgetsLastRow>{view});
      break;
    case Method::stopsBeforeBoundary:
      run(BrokenGather<Method::stopsBeforeBoundary>{view});
      break;
    case Method::trustsRowOrder:
      run(BrokenGather<Method::trustsRowOrder>{view});
      break;
  }
  test::Gathered result{found.download(), visits.download(), tested.download()};
  countLaunches(4);
  return result;
}

// One item: one cell that asks.
template <class Search>
struct LookAround {
  uint32_t *found, *visits, *tested;
  const Cell* cells;
  Search search;
  float radius;
  uint32_t wordsPerCell;

  GW_BODY void operator()(uint32_t i) const {
    const Cell self = cells[i];
    uint32_t* mine = found + i * wordsPerCell;
    uint32_t count = 0;
    visits[i] = tested[i] = 0;
    if (!isLiving(self.x)) return;
    const auto visit = [&](const Cell& cell, uint32_t index, float dx, float dy) {
      mine[cell.id / 32] |= 1u << cell.id % 32;
      const bool right = cells[index].id == cell.id && dx == cell.x - self.x && dy == cell.y - self.y;
      count += right ? 1 : 1000000;
    };
    const uint32_t all = search.around(i, self.x, self.y, radius, visit);
    visits[i] = count;
    const uint32_t later = search.after(i, self.x, self.y, radius, [](const Cell&, uint32_t, float, float) {});
    tested[i] = all + 65536 * later;
  }
};

test::Gathered gatherAround(const ExecOptions& options, test::GridShape shape, const std::vector<Cell>& start,
                            float radius, test::Around method) {
  Queue queue(options);
  NGrid grid(queue, {shape.columns, shape.rows});
  auto cells = uploaded(queue, start);
  const uint32_t n = shape.cells(), words = (n + 31) / 32;
  Buffer<uint32_t> cellOf(queue, n), found(queue, size_t(n) * words), visits(queue, n), tested(queue, n);
  found.upload(std::vector<uint32_t>(size_t(n) * words));
  grid.maintain(queue, cells.data(), cellOf.data());
  const auto run = [&](auto search) {
    forEach(
        queue, Count{n},
        LookAround<decltype(search)>{found.data(), visits.data(), tested.data(), cells.data(), search, radius, words});
  };
  const NGridView view = grid.view(cells.data());
  switch (method) {
    case test::Around::rows:
      run(RowGather{view});
      break;
    case test::Around::bruteForce:
      run(BruteForce{cells.data(), n});
      break;
    case test::Around::fixedWindow:
      run(FixedGather{view});
      break;
    case test::Around::adaptiveWindow:
      run(AdaptiveGather{view});
      break;
  }
  test::Gathered result{found.download(), visits.download(), tested.download()};
  countLaunches(4);
  return result;
}

}  // namespace

void addGatherProbes(test::Probes& probes) {
  probes.gather = gather;
  probes.gatherAround = gatherAround;
}

}  // namespace gw::GW_DEVICE
