// Makes every template of the library once, in two dimensions and in three: a compiler warns of what is in a template
// only where it is made. Never run.
#include <gpuwars/bin_sort.h>
#include <gpuwars/brute_force.h>
#include <gpuwars/exact_math.h>
#include <gpuwars/fixed_sum.h>
#include <gpuwars/hashed_grid.h>
#include <gpuwars/neighbour_lists.h>
#include <gpuwars/ngrid.h>
#include <gpuwars/philox.h>
#include <gpuwars/record_ring.h>
#include <gpuwars/row_gather.h>
#include <gpuwars/scan_reduce.h>
#include <gpuwars/sort_keys.h>
#include <gpuwars/stage_timer.h>
#include <gpuwars/state_hash.h>
#include <gpuwars/tick_graph.h>
#include <gpuwars/uniform_grid.h>
#include <gpuwars/window_gather.h>

namespace gw::GW_DEVICE {
namespace {

// One item: one cell.
template <class CellT, class Search>
struct Around {
  uint32_t* counts;
  const CellT* cells;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const auto count = [&](const CellT&, uint32_t, PlaceOf<CellT>) { ++counts[i]; };
    search.around(i, placeOf(cells[i]), 1.0f, count);
    search.after(i, placeOf(cells[i]), 1.0f, count);
  }
};

// The same for a place in the world.
template <class CellT, class Search>
struct From {
  uint32_t* counts;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    search(PlaceOf<CellT>{}, 1.0f, [&](const CellT&, uint32_t, PlaceOf<CellT>) { ++counts[i]; });
  }
};

// One team: as many words as lanes, summed.
struct Sum {
  static constexpr uint32_t kLanes = 64;
  using Shared = ScanShared<kLanes>;
  uint64_t* sums;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) { s.word[0][lane] = lane; });
    const uint64_t* before = scanShared<kLanes>(team, s);
    team.phase([&](uint32_t lane) {
      if (lane == 0) sums[team.index] = s.total + before[1];
    });
  }
};

struct BinOf {
  uint32_t bins;
  GW_BODY uint32_t operator()(uint32_t i) const { return i % bins; }
};
struct Move {
  uint32_t* to;
  GW_BODY void operator()(uint32_t from, uint32_t place) const { to[place] = from; }
};
struct Ones {
  GW_BODY uint64_t operator()(uint32_t) const { return 1; }
};

template <class CellT>
void search(Queue& queue, const Bins& bins, NDimensions dimensions) {
  const uint32_t n = dimensions.cells();
  NGrid<CellT> grid(queue, dimensions, Kept::packed);
  Buffer<CellT> cells(queue, n);
  Buffer<uint32_t> cellOf(queue, n), counts(queue, n);
  cells.upload(padded(std::vector<CellT>(n), dimensions));
  grid.rebuild(queue, cells.data(), cellOf.data());
  grid.maintain(queue, cells.data(), cellOf.data());
  UniformGrid<CellT> uniform(queue, n, bins);
  HashedGrid<CellT> hashed(queue, n, 1.0f);
  NeighbourLists lists(queue, n, n);

  const auto all = [&](const auto& method) {
    using Search = std::remove_cvref_t<decltype(method)>;
    forEach(queue, Count{n}, Around<CellT, Search>{counts.data(), cells.data(), method});
    if constexpr (requires { &Search::template operator()<Move>; }) {
      forEach(queue, Count{n}, From<CellT, Search>{counts.data(), method});
      lists.build(queue, method, cells.data(), 1.0f);
    }
  };
  all(RowGather{grid.view(cells.data())});
  all(BruteForce{cells.data(), n});
  all(uniform.view(cells.data()));
  all(hashed.view(cells.data()));
  all(FixedGather{grid.view(cells.data())});
  all(AdaptiveGather{grid.view(cells.data())});
}

}  // namespace

void everyTemplate(Queue& queue) {
  search<Cell>(queue, binsOver(Float2{0, 0}, Float2{1, 1}, 1.0f, 16), {4, 4});
  search<Cell3>(queue, binsOver(Float3{0, 0, 0}, Float3{1, 1, 1}, 1.0f, 64), {4, 4, 4});

  Buffer<uint64_t> words(queue, 64);
  Buffer<uint32_t> moved(queue, 64);
  forEachTeam(queue, 4, Sum{words.data()});
  BinSort(queue, 64, 8).run(queue, BinOf{8}, Move{moved.data()});
  Scan(queue, 64).run(queue, Ones{});
  SortKeys(queue, 64).run(queue);
  RecordRing<Cell> ring(queue, 2);
  ring.toHost(0, nullptr);
  StageTimer timer;
  timer.time(queue, "stage", [] {});
  timeAlone_ms(queue, [] {});
  TickGraph(queue, [] {}).replay(queue);
}

}  // namespace gw::GW_DEVICE
