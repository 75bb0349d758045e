// Partial odd-even transposition (Habermann 1972; the thesis's partial sort): a tick makes one odd and one even
// pass along each axis. A pass compares neighbouring cells of a line in pairs that share no cell, so its result does
// not depend on who goes first.
//
//   odd    0 [1 2] [3 4] [5 6] 7          What comes to a pair of the even pass depends on four cells before both:
//   even    [0 1] [2 3] [4 5] [6 7]       its own and the one on either side. So both are made in one launch, in which
//                                         a team has whole lines.
#include <gpuwars/ngrid.h>

#include <type_traits>

#include "detail/line_order.h"
#include "detail/ngrid_lines.h"
#include "detail/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

template <class CellT, class Less>
GW_BODY void putInOrder(CellT& first, CellT& second) {
  if (!Less{}(second, first)) return;
  const CellT kept = first;
  first = second;
  second = kept;
}

// One team: a tile of neighbouring lines, each with an odd and an even pass; along rows, which come last, it says where
// each id now stands.
template <class CellT, class Less, class LineTeamT>
struct TransposeLines {
  static constexpr uint32_t kLanes = LineTeamT::kLanes;
  static constexpr bool kIndexes = std::is_same_v<Less, ByX>;
  struct Shared {};
  CellT* cells;
  uint32_t* cellOf;
  uint32_t* moved;  // counted along rows, set to 0 by the first axis
  const uint32_t* hold;
  Lines lines;
  bool first;

  uint32_t teams() const { return tilesPerPlane(lines, linesPerTeam()) * lines.planes; }

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared&) const {
    team.phase([&](uint32_t lane) {
      if (first && team.index == 0 && lane == 0) *moved = 0;
    });
    if (hold && *hold) return;  // all teams alike
    transpose(team, tileOf(lines, linesPerTeam(), team.index));
  }

  // Whether the cell has moved.
  GW_BODY bool index(const CellT& cell, uint32_t at) const {
    if (cellOf[cell.id] == at) return false;
    cellOf[cell.id] = at;
    return true;
  }

#if GW_ON_CUDA
  GW_MEMBER uint32_t linesPerTeam() const {
    return LineTeamT::linesPerTeam(lines.length);
  }

  // Each lane works out its pairs of the even pass; when all of the team have read, they write.
  template <class Team>
  GW_BODY void transpose(const Team& team, const LineTile& tile) const {
    constexpr uint32_t kPairs = LineTeamT::kEach / 2;
    CellT pair[kPairs][2];
    team.phase([&](uint32_t lane) {
      for (uint32_t p = 0; p < kPairs; ++p) {
        const Pair mine = pairOf(p * kLanes + lane, tile);
        if (mine.column >= lines.length) continue;
        const auto cellAt = [&](uint32_t column) { return cells[mine.begin + column * lines.toNext]; };
        pair[p][0] = cellAt(mine.column);
        if (mine.column > 0) {
          CellT before = cellAt(mine.column - 1);
          putInOrder<CellT, Less>(before, pair[p][0]);
        }
        if (mine.column + 1 >= lines.length) continue;
        pair[p][1] = cellAt(mine.column + 1);
        if (mine.column + 2 < lines.length) {
          CellT after = cellAt(mine.column + 2);
          putInOrder<CellT, Less>(pair[p][1], after);
        }
        putInOrder<CellT, Less>(pair[p][0], pair[p][1]);
      }
    });
    team.phase([&](uint32_t lane) {
      uint32_t exchanged = 0;
      for (uint32_t p = 0; p < kPairs; ++p) {
        const Pair mine = pairOf(p * kLanes + lane, tile);
        for (uint32_t e = 0; e < 2; ++e) {
          if (mine.column + e >= lines.length) continue;
          const uint32_t at = mine.begin + (mine.column + e) * lines.toNext;
          cells[at] = pair[p][e];
          if constexpr (kIndexes) exchanged += index(pair[p][e], at);
        }
      }
      if (exchanged) atomicAddTo(*moved, exchanged);  // a sum: in any order
    });
  }

  struct Pair {
    uint32_t begin, column;  // of its line: where it begins in memory; the first of the pair, not below length for none
  };

  // Lanes beside each other have what lies beside each other in memory: pairs of a row, or columns.
  GW_BODY Pair pairOf(uint32_t i, const LineTile& tile) const {
    const uint32_t pairs = LineTeamT::stretchOf(lines.length) / 2, each = linesPerTeam();
    const bool alongLine = lines.toNext == 1;
    const uint32_t line = alongLine ? i / pairs : i % each, pair = alongLine ? i % pairs : i / each;
    if (line >= tile.count) return {0, lines.length};
    return {beginOf(lines, tile, line), 2 * pair};
  }
#else
  // Rows alone, and so many columns or poles that a cell's neighbours are still in the cache when it is compared again.
  uint32_t linesPerTeam() const {
    return lines.toNext == 1 ? 1 : 64;
  }

  template <class Team>
  void transpose(const Team&, const LineTile& tile) const {
    CellT* const line = cells + beginOf(lines, tile, 0);
    const auto pass = [&](uint32_t i) {
      CellT* const here = line + size_t(i) * lines.toNext;
      for (uint32_t t = 0; t < tile.count; ++t) putInOrder<CellT, Less>(here[t], here[t + lines.toNext]);
    };
    for (uint32_t i = 0; i + 1 < lines.length; i += 2) {
      if (i + 2 < lines.length) pass(i + 1);
      pass(i);
    }
    if constexpr (kIndexes) {
      uint32_t exchanged = 0;
      for (uint32_t c = 0; c < lines.length; ++c) exchanged += index(line[c], uint32_t(line + c - cells));
      if (exchanged) atomicAddTo(*moved, exchanged);  // a sum: in any order
    }
  }
#endif
};

template <class CellT, class Less>
void pass(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, uint32_t* d_moved, const uint32_t* d_hold,
          const Lines& lines, bool first) {
  withTeamFor(lines.length, [&](auto team) {
    const TransposeLines<CellT, Less, decltype(team)> passes{d_cells, d_cellOf, d_moved, d_hold, lines, first};
    forEachTeam(queue, passes.teams(), passes);
  });
}

}  // namespace

template <class CellT>
void NGrid<CellT>::transpose(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  requireBuffers(d_cells, d_cellOf);
  uint32_t* const d_moved = &totals_.data()->moved;
  if constexpr (!kFlat<CellT>) {
    pass<CellT, ByZ>(queue, d_cells, d_cellOf, d_moved, d_hold, polesOf(dimensions_), true);
  }
  pass<CellT, ByY>(queue, d_cells, d_cellOf, d_moved, d_hold, columnsOf(dimensions_), kFlat<CellT>);
  pass<CellT, ByX>(queue, d_cells, d_cellOf, d_moved, d_hold, rowsOf(dimensions_), false);
  rounds_ = 1;
}

template void NGrid<Cell>::transpose(Queue&, Cell*, uint32_t*, const uint32_t*);
template void NGrid<Cell3>::transpose(Queue&, Cell3*, uint32_t*, const uint32_t*);

}  // namespace gw::GW_DEVICE
