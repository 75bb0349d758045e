#include <stdexcept>

#include "gpu/neighbours/brute_force.h"
#include "gpu/neighbours/hashed_grid.h"
#include "gpu/neighbours/neighbour_lists.h"
#include "gpu/neighbours/uniform_grid.h"
#include "gpu/ngrid/row_gather.h"
#include "gpu/ngrid/window_gather.h"
#include "tests/gpu/neighbours/broken_gather.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

GW_FN Float2 askedAt(const test::Query& query) {
  return {query.x, query.y};
}
GW_FN Float3 askedAt(const test::Query3& query) {
  return {query.x, query.y, query.z};
}

template <class Place>
GW_FN bool same(Place a, Place b) {
  return a.x == b.x && a.y == b.y && heightOf(a) == heightOf(b);
}

// One item: one query.
template <class Search, class Query>
struct Find {
  uint32_t *found, *visits, *tested;
  const Query* queries;
  const uint32_t* cellOf;
  Search search;
  uint32_t wordsPerQuery;

  GW_BODY void operator()(uint32_t i) const {
    const auto at = askedAt(queries[i]);
    uint32_t* mine = found + i * wordsPerQuery;
    uint32_t count = 0;
    tested[i] = search(at, queries[i].radius, [&](const auto& cell, uint32_t index, auto away) {
      mine[cell.id / 32] |= 1u << cell.id % 32;
      // A visit whose index or difference is wrong counts a thousandfold, which no right answer does.
      count += cellOf[cell.id] == index && same(away, placeOf(cell) - at) ? 1 : 1000000;
    });
    visits[i] = count;
  }
};

// The answers of one run.
struct Answers {
  Buffer<uint32_t> found, visits, tested;
  uint32_t words;

  Answers(Queue& queue, uint32_t queries, uint32_t cells)
      : found(queue, size_t(queries) * ((cells + 31) / 32)),
        visits(queue, queries),
        tested(queue, queries),
        words((cells + 31) / 32) {}
  test::Gathered download() const { return {found.download(), visits.download(), tested.download()}; }
};

template <class CellT>
UniformGrid<CellT> gridFor(Queue& queue, uint32_t cells);
template <>
UniformGrid<Cell> gridFor(Queue& queue, uint32_t cells) {
  return {queue, cells, binsOver(Float2{0, 0}, Float2{test::kRegion, test::kRegion}, test::binSizeFor(cells), cells)};
}
template <>
UniformGrid<Cell3> gridFor(Queue& queue, uint32_t cells) {
  constexpr float kFar = test::kRegion;
  return {queue, cells, binsOver(Float3{0, 0, 0}, Float3{kFar, kFar, kFar}, test::binSizeFor(cells), cells)};
}

// What is searched: the cells, and whatever structure the method keeps of them.
template <class CellT>
struct Searched {
  Queue& queue;
  Buffer<CellT> cells;
  Buffer<uint32_t> cellOf;
  NGrid<CellT> rows;
  UniformGrid<CellT> bins;
  HashedGrid<CellT> hashed;
  uint32_t count;

  Searched(Queue& q, const std::vector<CellT>& start)
      : queue(q), cells(uploaded(q, start)), cellOf(q, start.size()), count(uint32_t(start.size())) {
    std::vector<uint32_t> own(count);
    for (uint32_t i = 0; i < count; ++i) own[start[i].id] = i;
    cellOf.upload(own);
  }

  NGridView<CellT> inRows(test::GridShape shape, Kept kept, bool built) {
    rows = NGrid<CellT>(queue, {shape.columns, shape.rows, shape.slabs}, kept);
    if (built) rows.rebuild(queue, cells.data(), cellOf.data());
    return rows.view(cells.data());
  }
  NGridView<CellT> maintainRows(test::GridShape shape) {
    const auto view = inRows(shape, Kept::inPlace, false);
    rows.maintain(queue, cells.data(), cellOf.data());
    return view;
  }
  NGridView<CellT> refreshRows(test::GridShape shape) {
    const auto view = inRows(shape, Kept::packed, false);
    rows.refresh(queue, cells.data(), cellOf.data());
    return view;
  }
  NGridView<CellT> packRows(test::GridShape shape) {
    const auto view = inRows(shape, Kept::packed, true);
    rows.pack(queue, cells.data(), cellOf.data());
    return view;
  }
  NGridView<CellT> buildRows(test::GridShape shape) { return inRows(shape, Kept::inPlace, true); }
  BruteForce<CellT> asTheyAre() { return {cells.data(), count}; }
  GridGather<CellT> inBins() {
    bins = gridFor<CellT>(queue, count);
    bins.maintain(queue, cells.data(), cellOf.data());
    return bins.view(cells.data());
  }
  HashedGather<CellT> inBuckets() {
    hashed = HashedGrid<CellT>(queue, count, test::binSizeFor(count));
    hashed.maintain(queue, cells.data());
    return hashed.view(cells.data());
  }
};

template <class Query>
struct Asking {
  Queue& queue;
  Buffer<Query> queries;
  Answers answers;
  const uint32_t* cellOf;

  template <class Search>
  void operator()(const Search& search) {
    forEach(queue, Count{uint32_t(queries.size())},
            Find<Search, Query>{answers.found.data(), answers.visits.data(), answers.tested.data(), queries.data(),
                                cellOf, search, answers.words});
  }
};

template <class CellT, class Ask>
void askRightly(Searched<CellT>& searched, Ask& ask, test::GridShape shape, test::Method method) {
  using test::Method;
  switch (method) {
    case Method::rows:
      return ask(RowGather{searched.maintainRows(shape)});
    case Method::frozenRows:
      return ask(RowGather{searched.refreshRows(shape)});
    case Method::packedRows:
      return ask(RowGather{searched.packRows(shape)});
    case Method::builtRows:
      return ask(RowGather{searched.buildRows(shape)});
    case Method::bruteForce:
      return ask(searched.asTheyAre());
    case Method::grid:
      return ask(searched.inBins());
    case Method::hashedGrid:
      return ask(searched.inBuckets());
    default:
      throw std::logic_error("That method has a mistake, and is flat.");
  }
}

test::Gathered gather(const ExecOptions& options, test::GridShape shape, const std::vector<Cell>& start,
                      const std::vector<test::Query>& queries, test::Method method) {
  Queue queue(options);
  Searched<Cell> searched(queue, start);
  Asking<test::Query> ask{queue, uploaded(queue, queries), Answers(queue, uint32_t(queries.size()), searched.count),
                          searched.cellOf.data()};
  using test::Method;
  switch (method) {
    case Method::noMistake:
      ask(BrokenGather<Method::noMistake>{searched.maintainRows(shape)});
      break;
    case Method::prunesByEdge:
      ask(BrokenGather<Method::prunesByEdge>{searched.maintainRows(shape)});
      break;
    case Method::forgetsLastRow:
      ask(BrokenGather<Method::forgetsLastRow>{searched.maintainRows(shape)});
      break;
    case Method::stopsBeforeBoundary:
      ask(BrokenGather<Method::stopsBeforeBoundary>{searched.maintainRows(shape)});
      break;
    case Method::trustsRowOrder:
      ask(BrokenGather<Method::trustsRowOrder>{searched.maintainRows(shape)});
      break;
    default:
      askRightly(searched, ask, shape, method);
  }
  const test::Gathered result = ask.answers.download();
  return result;
}

test::Gathered gather3(const ExecOptions& options, test::GridShape shape, const std::vector<Cell3>& start,
                       const std::vector<test::Query3>& queries, test::Method method) {
  Queue queue(options);
  Searched<Cell3> searched(queue, start);
  Asking<test::Query3> ask{queue, uploaded(queue, queries), Answers(queue, uint32_t(queries.size()), searched.count),
                           searched.cellOf.data()};
  askRightly(searched, ask, shape, method);
  const test::Gathered result = ask.answers.download();
  return result;
}

// One item: one beginning, copied to where the host can download it from.
struct CopyWords {
  uint32_t* out;
  const uint32_t* in;
  GW_BODY void operator()(uint32_t i) const { out[i] = in[i]; }
};

std::vector<uint32_t> downloaded(Queue& queue, const uint32_t* words, uint32_t count) {
  Buffer<uint32_t> copy(queue, count);
  forEach(queue, Count{count}, CopyWords{copy.data(), words});
  return copy.download();
}

test::Binned binCells(const ExecOptions& options, const std::vector<Cell>& start) {
  Queue queue(options);
  Searched<Cell> searched(queue, start);
  const auto view = searched.inBins();
  test::Binned result{searched.cells.download(), searched.cellOf.download(),
                      downloaded(queue, view.begin, view.bins.all() + 2)};
  return result;
}

test::Binned hashCells(const ExecOptions& options, const std::vector<Cell>& start) {
  Queue queue(options);
  Searched<Cell> searched(queue, start);
  const auto view = searched.inBuckets();
  test::Binned result{searched.cells.download(), downloaded(queue, view.index, view.count),
                      downloaded(queue, view.begin, view.count + 2)};
  return result;
}

// One item: one cell that asks.
template <class CellT, class Search>
struct LookAround {
  uint32_t *found, *visits, *tested;
  const CellT* cells;
  Search search;
  float radius;
  uint32_t wordsPerCell;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    uint32_t* mine = found + i * wordsPerCell;
    uint32_t count = 0;
    visits[i] = tested[i] = 0;
    if (!isLiving(self.x)) return;
    const auto visit = [&](const CellT& cell, uint32_t index, PlaceOf<CellT> away) {
      mine[cell.id / 32] |= 1u << cell.id % 32;
      count += cells[index].id == cell.id && same(away, placeOf(cell) - placeOf(self)) ? 1 : 1000000;
    };
    const uint32_t all = search.around(i, placeOf(self), radius, visit);
    visits[i] = count;
    const uint32_t later = search.after(i, placeOf(self), radius, [](const CellT&, uint32_t, PlaceOf<CellT>) {});
    tested[i] = all + 65536 * later;
  }
};

template <class CellT>
test::Gathered gatherAround(const ExecOptions& options, test::GridShape shape, const std::vector<CellT>& start,
                            float radius, test::Around method) {
  Queue queue(options);
  Searched<CellT> searched(queue, start);
  const uint32_t n = shape.cells();
  Answers answers(queue, n, n);
  answers.found.upload(std::vector<uint32_t>(answers.found.size()));
  const auto run = [&](auto search) {
    forEach(queue, Count{n},
            LookAround<CellT, decltype(search)>{answers.found.data(), answers.visits.data(), answers.tested.data(),
                                                searched.cells.data(), search, radius, answers.words});
  };
  switch (method) {
    case test::Around::rows:
      run(RowGather{searched.maintainRows(shape)});
      break;
    case test::Around::packedRows:
      run(RowGather{searched.packRows(shape)});
      break;
    case test::Around::bruteForce:
      run(searched.asTheyAre());
      break;
    case test::Around::grid:
      run(searched.inBins());
      break;
    case test::Around::hashedGrid:
      run(searched.inBuckets());
      break;
    case test::Around::fixedWindow:
      run(FixedGather{searched.maintainRows(shape)});
      break;
    case test::Around::adaptiveWindow:
      run(AdaptiveGather{searched.maintainRows(shape)});
      break;
  }
  const test::Gathered result = answers.download();
  return result;
}

template <class CellT>
test::Lists lists(const ExecOptions& options, test::GridShape shape, const std::vector<CellT>& start, float radius,
                  test::Method method) {
  Queue queue(options);
  Searched<CellT> searched(queue, start);
  const uint32_t n = shape.cells();
  NeighbourLists lists(queue, n, n * n);
  const auto build = [&](const auto& search) { lists.build(queue, search, searched.cells.data(), radius); };
  askRightly(searched, build, shape, method);
  return {lists.downloadBegin(), lists.downloadNeighbours()};
}

}  // namespace

void addGatherProbes(test::Probes& probes) {
  probes.gather = gather;
  probes.gather3 = gather3;
  probes.binCells = binCells;
  probes.hashCells = hashCells;
  probes.gatherAround = gatherAround<Cell>;
  probes.gatherAround3 = gatherAround<Cell3>;
  probes.lists = lists<Cell>;
  probes.lists3 = lists<Cell3>;
}

}  // namespace gw::GW_DEVICE
