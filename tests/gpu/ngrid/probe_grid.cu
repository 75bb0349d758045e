#include "gpu/ngrid/detail/line_order.h"
#include "gpu/ngrid/detail/ngrid_lines.h"
#include "gpu/ngrid/ngrid.h"
#include "tests/gpu/probe_parts.h"

#if GW_ON_CUDA
#include "gpu/ngrid/detail/block_lines.h"
#else
#include "gpu/ngrid/detail/line_sort.h"
#endif

namespace gw::GW_DEVICE {
namespace {

// One team in all: sorts one line.
template <class CellT, class Less, class LineTeamT>
struct SortOneLine {
  static constexpr uint32_t kLanes = LineTeamT::kLanes;
#if GW_ON_CUDA
  using Shared = typename BlockLines<CellT, LineTeamT>::Shared;
#else
  struct Shared {};
#endif
  CellT* cells;
  uint32_t length;

  template <class Team>
  GW_BODY void operator()(const Team&, [[maybe_unused]] Shared& s) const {
#if GW_ON_CUDA
    const bool mine = BlockLines<CellT, LineTeamT>::lineOf(length) == 0;
    BlockLines<CellT, LineTeamT> line(s, cells, mine ? length : 0, 1, length);
    line.sort(Less{});
    line.forEach([&](uint32_t i, const CellT& cell) { cells[i] = cell; });
#else
    sortLine(cells, length, Less{});
#endif
  }
};

template <class CellT, class Less>
std::vector<CellT> sortOneLine(const ExecOptions& options, const std::vector<CellT>& line) {
  Queue queue(options);
  auto cells = uploaded(queue, line);
  const uint32_t length = uint32_t(line.size());
  withTeamFor(length, [&](auto team) {
    forEachTeam(queue, 1, SortOneLine<CellT, Less, decltype(team)>{cells.data(), length});
  });
  auto result = cells.download();
  return result;
}

// One item: one word or interval, copied to where the host can download it from.
template <class T>
struct CopyItems {
  T* out;
  const T* in;
  GW_BODY void operator()(uint32_t i) const { out[i] = in[i]; }
};

template <class T>
std::vector<T> downloaded(Queue& queue, const T* d_items, size_t count) {
  if (!d_items) return {};
  Buffer<T> copy(queue, count);
  forEach(queue, Count{uint32_t(count)}, CopyItems<T>{copy.data(), d_items});
  return copy.download();
}

// One item: one cell.
template <class CellT>
struct Stretch {
  CellT* cells;
  GW_BODY static void stretch(float& place) { place *= test::kStretch; }
  GW_BODY static void stretch(Cell& cell) {
    stretch(cell.x);
    stretch(cell.y);
  }
  GW_BODY static void stretch(Cell3& cell) {
    stretch(cell.x);
    stretch(cell.y);
    stretch(cell.z);
  }
  GW_BODY void operator()(uint32_t i) const { stretch(cells[i]); }
};

template <class CellT>
struct KeptGrid {
  Queue queue;
  NGrid<CellT> grid;
  Buffer<CellT> cells;
  Buffer<uint32_t> cellOf;

  KeptGrid(const ExecOptions& options, test::GridShape shape, const std::vector<CellT>& start, test::Upkeep upkeep)
      : queue(options),
        grid(queue, {shape.columns, shape.rows, shape.slabs}, keptBy(upkeep)),
        cells(uploaded(queue, start)),
        cellOf(queue, start.size()) {
    std::vector<uint32_t> own(start.size());
    for (uint32_t i = 0; i < own.size(); ++i) own[start[i].id] = i;
    cellOf.upload(own);
    keep(upkeep);
  }

  static Kept keptBy(test::Upkeep upkeep) {
    using test::Upkeep;
    const bool packed = upkeep == Upkeep::pack || upkeep == Upkeep::repack || upkeep == Upkeep::refresh;
    return packed ? Kept::packed : Kept::inPlace;
  }

  void keep(test::Upkeep upkeep) {
    switch (upkeep) {
      case test::Upkeep::maintain:
        return grid.maintain(queue, cells.data(), cellOf.data());
      case test::Upkeep::rebuild:
        return grid.rebuild(queue, cells.data(), cellOf.data());
      case test::Upkeep::refresh:
        return grid.refresh(queue, cells.data(), cellOf.data());
      case test::Upkeep::sortUntilStable:
        return grid.sortUntilStable(queue, cells.data(), cellOf.data());
      case test::Upkeep::transpose:
        return grid.transpose(queue, cells.data(), cellOf.data());
      case test::Upkeep::pack:
      case test::Upkeep::repack:
        grid.rebuild(queue, cells.data(), cellOf.data());
        if (upkeep == test::Upkeep::repack) forEach(queue, Count{uint32_t(cells.size())}, Stretch<CellT>{cells.data()});
        return grid.pack(queue, cells.data(), cellOf.data());
    }
  }
};

template <class CellT>
test::GridStateOf<CellT> upkeep(const ExecOptions& options, test::GridShape shape, const std::vector<CellT>& start,
                                test::Upkeep upkeep) {
  KeptGrid<CellT> kept(options, shape, start, upkeep);
  Queue& queue = kept.queue;
  const NGridView<CellT> view = kept.grid.view(kept.cells.data());
  test::GridStateOf<CellT> state;
  state.cells = kept.cells.download();
  state.cellOf = kept.cellOf.download();
  state.moved = downloaded(queue, view.totals, 1)[0].moved;
  if (upkeep == test::Upkeep::transpose) return state;
  const uint32_t lines = shape.lines();
  state.living = downloaded(queue, view.living, lines);
  for (const Interval& y : downloaded(queue, view.height, lines)) {
    state.low.push_back(y.low);
    state.high.push_back(y.high);
  }
  for (const Interval& reach : downloaded(queue, view.reach, lines)) {
    state.reachLow.push_back(reach.low);
    state.reachHigh.push_back(reach.high);
  }
  for (const Interval& z : downloaded(queue, view.depth, lines)) {
    state.near.push_back(z.low);
    state.far.push_back(z.high);
  }
  if (!kFlat<CellT>) {
    for (const GridSlab& slab : downloaded(queue, view.slab, shape.slabs)) {
      state.slabReachLow.push_back(slab.reach.low);
      state.slabReachHigh.push_back(slab.reach.high);
    }
  }
  for (const uint16_t first : downloaded(queue, view.firstColumn, size_t(lines) * (view.parts + 1))) {
    state.starts.push_back(first);
  }
  return state;
}

template <class CellT>
test::GridReport report(const ExecOptions& options, test::GridShape shape, const std::vector<CellT>& start,
                        test::Upkeep upkeep) {
  KeptGrid<CellT> kept(options, shape, start, upkeep);
  const UpkeepReport report = kept.grid.upkeepReport(kept.queue, kept.cells.data());
  const Steps steps = kept.grid.steps(kept.queue, kept.cells.data());
  return {report.misaligned, report.moved, report.rounds, {steps.along[0], steps.along[1], steps.along[2]}};
}

}  // namespace

void addGridProbes(test::Probes& probes) {
  probes.sortLineByX = sortOneLine<Cell, ByX>;
  probes.sortLineByY = sortOneLine<Cell, ByY>;
  probes.sortLineByZ = sortOneLine<Cell3, ByZ>;
  probes.upkeep = upkeep<Cell>;
  probes.upkeep3 = upkeep<Cell3>;
  probes.report = report<Cell>;
  probes.report3 = report<Cell3>;
}

}  // namespace gw::GW_DEVICE
