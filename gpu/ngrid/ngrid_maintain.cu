// Upkeep by sorting lines: every pole by z, every column by y, every row by x; and what is then known of the rows.
#include <gpuwars/ngrid.h>

#include <stdexcept>

#include "detail/line_order.h"
#include "detail/ngrid_keep_rows.h"
#include "detail/ngrid_lines.h"
#include "detail/ngrid_rows.h"

#if GW_ON_CUDA
#include "detail/block_lines.h"
#else
#include "detail/line_sort.h"
#endif

namespace gw::GW_DEVICE {
namespace {

// One team: a tile of neighbouring lines, each sorted.
template <class CellT, class Less, class LineTeamT>
struct SortLines {
  static constexpr uint32_t kLanes = LineTeamT::kLanes;
#if GW_ON_CUDA
  using Shared = typename BlockLines<CellT, LineTeamT>::Shared;
#else
  static constexpr uint32_t kTile = 4;  // one cache line wide
  struct Shared {
    CellT line[kTile][LineTeamT::kCapacity];
  };
#endif
  CellT* cells;
  const uint32_t* hold;
  Lines lines;

  uint32_t teams() const {
    return tilesPerPlane(lines, linesPerTeam()) * lines.planes;
  }

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;  // all teams alike
    sort(s, tileOf(lines, linesPerTeam(), team.index));
  }

#if GW_ON_CUDA
  GW_MEMBER uint32_t linesPerTeam() const {
    return LineTeamT::linesPerTeam(lines.length);
  }

  GW_BODY void sort(Shared& s, const LineTile& tile) const {
    const uint32_t mine = BlockLines<CellT, LineTeamT>::lineOf(lines.length);
    CellT* const first = cells + beginOf(lines, tile, mine);
    BlockLines<CellT, LineTeamT> line(s, first, mine < tile.count ? lines.length : 0, lines.toNext, lines.length);
    line.sort(Less{});
    line.forEach([&](uint32_t i, const CellT& cell) { first[size_t(i) * lines.toNext] = cell; });
  }
#else
  uint32_t linesPerTeam() const {
    return kTile;
  }

  void sort(Shared& s, const LineTile& tile) const {
    CellT* const first = cells + beginOf(lines, tile, 0);
    for (uint32_t i = 0; i < lines.length; ++i) {
      for (uint32_t t = 0; t < tile.count; ++t) s.line[t][i] = first[size_t(i) * lines.toNext + t];
    }
    for (uint32_t t = 0; t < tile.count; ++t) sortLine(s.line[t], lines.length, Less{});
    for (uint32_t i = 0; i < lines.length; ++i) {
      for (uint32_t t = 0; t < tile.count; ++t) first[size_t(i) * lines.toNext + t] = s.line[t][i];
    }
  }
#endif
};

template <class CellT, class Less>
void sortLines(Queue& queue, CellT* d_cells, const uint32_t* d_hold, const Lines& lines) {
  withTeamFor(lines.length, [&](auto team) {
    const SortLines<CellT, Less, decltype(team)> sort{d_cells, d_hold, lines};
    forEachTeam(queue, sort.teams(), sort);
  });
}

}  // namespace

void requireCells(const void* d_cells) {
  if (!d_cells) throw std::invalid_argument("d_cells is null; give the grid a buffer with a cell for each of its own.");
}

void requireBuffers(const void* d_cells, const void* d_cellOf) {
  requireCells(d_cells);
  if (!d_cellOf) throw std::invalid_argument("d_cellOf is null; give the grid a buffer with a word for each cell.");
}

template <class CellT>
void NGrid<CellT>::maintain(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  requireBuffers(d_cells, d_cellOf);
  if constexpr (!kFlat<CellT>) {
    if (dimensions_.slabs > 1) sortLines<CellT, ByZ>(queue, d_cells, d_hold, polesOf(dimensions_));
  }
  sortLines<CellT, ByY>(queue, d_cells, d_hold, columnsOf(dimensions_));
  sortRows(queue, d_cells, d_cellOf, d_hold, false);
  rounds_ = 1;
}

template <class CellT>
void NGrid<CellT>::sortUntilStable(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  uint32_t rounds = 0;
  do {
    maintain(queue, d_cells, d_cellOf);
    ++rounds;
  } while (totals().moved > 0);
  rounds_ = rounds;
}

template <class CellT>
void NGrid<CellT>::sortRows(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold, bool built) {
  withTeamFor(dimensions_.columns, [&](auto team) {
    const KeepRows<CellT, decltype(team), SortedRows> keep{
        d_cells, d_cells, d_cellOf, findReach(built), arrived_.data(), d_hold, rowsOf(dimensions_)};
    forEachTeam(queue, keep.teams(), keep);
  });
  known_ = true;
}

template void NGrid<Cell>::maintain(Queue&, Cell*, uint32_t*, const uint32_t*);
template void NGrid<Cell3>::maintain(Queue&, Cell3*, uint32_t*, const uint32_t*);
template void NGrid<Cell>::sortUntilStable(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::sortUntilStable(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::sortRows(Queue&, Cell*, uint32_t*, const uint32_t*, bool);
template void NGrid<Cell3>::sortRows(Queue&, Cell3*, uint32_t*, const uint32_t*, bool);

}  // namespace gw::GW_DEVICE
