// Upkeep by sorting lines: every pole by z, every column by y, every row by x; and what is then known of the rows.
#include <stdexcept>

#include "gpu/line_sort.h"
#include "gpu/neighbour.h"
#include "gpu/ngrid.h"
#include "gpu/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

// Lines of one axis that lie in memory beside each other: columns of a slab, or all poles.
struct Lines {
  uint32_t length, toNext;   // cells of a line; from one to the next
  uint32_t perPlane, plane;  // lines that begin in a row; from one such row to the next
};

// One team: a tile of neighbouring lines, each sorted. On cpu a tile is one cache line wide.
template <class CellT, class Less>
struct SortLines {
  static constexpr uint32_t kLanes = kLineLanes;
  static constexpr uint32_t kTile = GW_ON_CUDA ? 1 : 4;
  struct Shared {
    CellT line[kTile][kLongestLine];
  };
  CellT* cells;
  const uint32_t* hold;
  Lines lines;

  uint32_t tiles() const { return (lines.perPlane + kTile - 1) / kTile; }

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;  // all teams alike
    const uint32_t tilesPerPlane = (lines.perPlane + kTile - 1) / kTile;
    const uint32_t inPlane = team.index % tilesPerPlane * kTile;
    const uint32_t tile = lines.perPlane - inPlane < kTile ? lines.perPlane - inPlane : kTile;
    CellT* const first = cells + size_t(team.index / tilesPerPlane) * lines.plane + inPlane;
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < lines.length; i += kLanes) {
        for (uint32_t t = 0; t < tile; ++t) s.line[t][i] = first[size_t(i) * lines.toNext + t];
      }
    });
    for (uint32_t t = 0; t < tile; ++t) sortLine<kLanes>(team, s.line[t], lines.length, Less{});
    team.phase([&](uint32_t lane) {
      for (uint32_t i = lane; i < lines.length; i += kLanes) {
        for (uint32_t t = 0; t < tile; ++t) first[size_t(i) * lines.toNext + t] = s.line[t][i];
      }
    });
  }
};

// One team: one row, sorted by x; then what there is to know of it, and where each id now stands.
template <class CellT>
struct SortRows {
  static constexpr uint32_t kLanes = kLineLanes;
  struct Shared {
#if GW_ON_CUDA
    CellT line[kLongestLine];
#endif
    LivingBox box[kLanes];
  };
  CellT* cells;
  uint32_t* cellOf;
  RowsFound found;
  const uint32_t* hold;
  uint32_t columns;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;
    const uint32_t begin = team.index * columns;
#if GW_ON_CUDA
    CellT* const line = s.line;
    team.phase([&](uint32_t lane) {
      for (uint32_t c = lane; c < columns; c += kLanes) line[c] = cells[begin + c];
    });
#else
    CellT* const line = cells + begin;  // where it is
#endif
    sortLine<kLanes>(team, line, columns, ByX{});
    team.phase([&](uint32_t lane) {
      LivingBox box = LivingBox::nothing();
      for (uint32_t c = lane; c < columns; c += kLanes) {
        const CellT cell = line[c];
#if GW_ON_CUDA
        cells[begin + c] = cell;
#endif
        box.moved += cellOf[cell.id] != begin + c;
        cellOf[cell.id] = begin + c;
        box.take(cell);
      }
      s.box[lane] = box;
    });
    joinBoxes<kLanes>(team, s.box);
    team.phase([&](uint32_t lane) {
      if (lane == 0) writeRow(found, team.index, s.box[0]);
    });
    team.phase([&](uint32_t lane) { indexRow(team.index, line, lane, s.box[0].living); });
  }

  // Lane by lane: the parts of x that begin at each living cell, then those after the last.
  GW_BODY void indexRow(uint32_t line, const CellT* cell, uint32_t lane, uint32_t count) const {
    const Scale scale = scaleOf(found.before->x, found.parts);
    uint16_t* const mine = found.firstColumn + size_t(line) * (found.parts + 1);
    for (uint32_t c = lane; c <= count; c += kLanes) {
      const uint32_t first = c == 0 ? 0 : partOf(scale, found.parts, cell[c - 1].x) + 1;
      const uint32_t last = c == count ? found.parts : partOf(scale, found.parts, cell[c].x);
      for (uint32_t p = first; p <= last; ++p) mine[p] = uint16_t(c);
    }
  }
};

// For each of `parts` parts the first of `count` rows, or slabs, that reaches into it or beyond.
template <class HighOf>
GW_BODY void indexReach(uint16_t* firstOf, uint32_t parts, Scale scale, uint32_t count, uint32_t lane, uint32_t lanes,
                        const HighOf& highOf) {
  for (uint32_t part = lane; part < parts; part += lanes) {
    uint32_t begin = 0, rest = count;
    while (rest > 1) {
      const uint32_t half = rest / 2;
      begin += partOf(scale, parts, highOf(begin + half - 1)) < part ? half : 0;
      rest -= half;
    }
    firstOf[part] = uint16_t(begin);
  }
}

GW_BODY inline GridTotals addedUp(GridTotals a, const GridTotals& b) {
  a.height += b.height;
  a.x = joined(a.x, b.x);
  a.y = joined(a.y, b.y);
  a.z = joined(a.z, b.z);
  a.moved += b.moved;
  return a;
}

GW_BODY inline GridTotals noTotals() {
  GridTotals none{};
  none.x = none.y = none.z = {kInfinity, -kInfinity};
  return none;
}

// `all` replaces what the upkeep before has left.
GW_BODY inline void writeTotals(GridTotals* totals, GridTotals all, uint32_t parts, bool built) {
  all.heightBuilt = built ? all.height : totals->heightBuilt;
  all.parts = scaleOf(totals->x, parts);  // by which the rows were indexed
  *totals = all;
}

// One team: of one slab, the running maximum of the rows' highest y and the running minimum, from behind, of the
// lowest; and where to begin. Of a flat grid also what is known of the whole.
struct FindReach {
  static constexpr uint32_t kLanes = 64;
  struct Shared {
    GridTotals lane[kLanes], all;
  };
  Interval* reach;
  uint16_t* firstRow;
  GridSlab* slab;
  GridTotals *slabTotals, *totals;  // [slabs], null in 2D; of all
  RowsFound found;
  const uint32_t* hold;
  uint32_t rows, built;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;  // or the index would be read by another scale than it was written by
    const uint32_t each = (rows + kLanes - 1) / kLanes, base = team.index * rows;
    team.phase([&](uint32_t lane) {
      GridTotals mine = noTotals();
      for (uint32_t line = base + lane * each; line < base + smaller((lane + 1) * each, rows); ++line) {
        const Interval y = found.height[line];
        mine = addedUp(mine, {y.high > y.low ? y.high - y.low : 0.0f,
                              0.0f,
                              found.width[line],
                              y,
                              found.depth ? found.depth[line] : Interval{kInfinity, -kInfinity},
                              {},
                              {},
                              found.moved[line]});
      }
      s.lane[lane] = mine;
    });
    team.phase([&](uint32_t lane) {
      float most = -kInfinity, least = kInfinity;
      for (uint32_t l = 0; l < lane; ++l) most = larger(most, s.lane[l].y.high);
      for (uint32_t l = lane + 1; l < kLanes; ++l) least = smaller(least, s.lane[l].y.low);
      const uint32_t begin = base + lane * each, end = base + smaller((lane + 1) * each, rows);
      for (uint32_t line = begin; line < end; ++line) reach[line].high = most = larger(most, found.height[line].high);
      for (uint32_t line = end; line > begin; --line) {
        reach[line - 1].low = least = smaller(least, found.height[line - 1].low);
      }
      if (lane != 0) return;
      s.all = noTotals();
      for (uint32_t l = 0; l < kLanes; ++l) s.all = addedUp(s.all, s.lane[l]);
      slab[team.index].rows = scaleOf(s.all.y, rows * kPartsPerRow);
      if (slabTotals) {
        slabTotals[team.index] = s.all;
      } else {
        writeTotals(totals, s.all, found.parts, built);
      }
    });
    team.phase([&](uint32_t lane) {
      const uint32_t parts = rows * kPartsPerRow;
      indexReach(firstRow + team.index * parts, parts, scaleOf(s.all.y, parts), rows, lane, kLanes,
                 [&](uint32_t row) { return reach[base + row].high; });
    });
  }
};

// One team in all: the same over slabs.
struct FindSlabReach {
  static constexpr uint32_t kLanes = 64;
  struct Shared {};
  GridSlab* slab;
  uint16_t* firstSlab;
  GridTotals* totals;
  const GridTotals* slabTotals;
  const uint32_t* hold;
  uint32_t slabs, parts, built;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared&) const {
    if (hold && *hold) return;
    team.phase([&](uint32_t lane) {
      if (lane != 0) return;
      GridTotals all = noTotals();
      for (uint32_t i = 0; i < slabs; ++i) {
        all = addedUp(all, slabTotals[i]);
        slab[i].reach.high = all.z.high;
      }
      float least = kInfinity;
      for (uint32_t i = slabs; i > 0; --i) slab[i - 1].reach.low = least = smaller(least, slabTotals[i - 1].z.low);
      all.slabs = scaleOf(all.z, slabs * kPartsPerRow);
      writeTotals(totals, all, parts, built);
    });
    team.phase([&](uint32_t lane) {
      indexReach(firstSlab, slabs * kPartsPerRow, totals->slabs, slabs, lane, kLanes,
                 [&](uint32_t i) { return slab[i].reach.high; });
    });
  }
};

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
  const uint32_t columns = dimensions_.columns, rows = dimensions_.rows, slabs = dimensions_.slabs;
  if (slabs > 1) {
    const SortLines<CellT, ByZ> poles{d_cells, d_hold, {slabs, columns * rows, columns * rows, 0}};
    forEachTeam(queue, poles.tiles(), poles);
  }
  const SortLines<CellT, ByY> sortColumns{d_cells, d_hold, {rows, columns, columns, columns * rows}};
  forEachTeam(queue, sortColumns.tiles() * slabs, sortColumns);
  sortRows(queue, d_cells, d_cellOf, d_hold, false);
  rounds_ = 1;
}

template <class CellT>
void NGrid<CellT>::settle(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  uint32_t rounds = 0;
  do {
    maintain(queue, d_cells, d_cellOf);
    ++rounds;
  } while (totals().moved > 0);
  rounds_ = rounds;
}

template <class CellT>
void NGrid<CellT>::sortRows(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold, bool built) {
  forEachTeam(queue, dimensions_.lines(), SortRows<CellT>{d_cells, d_cellOf, found(), d_hold, dimensions_.columns});
  findReach(queue, built, d_hold);
}

template <class CellT>
void NGrid<CellT>::findReach(Queue& queue, bool built, const uint32_t* d_hold) {
  const uint32_t slabs = dimensions_.slabs;
  forEachTeam(queue, slabs,
              FindReach{reach_.data(), firstRow_.data(), slab_.data(), slabTotals_.data(), totals_.data(), found(),
                        d_hold, dimensions_.rows, built});
  if (!kFlat<CellT>) {
    forEachTeam(queue, 1,
                FindSlabReach{slab_.data(), firstSlab_.data(), totals_.data(), slabTotals_.data(), d_hold, slabs,
                              parts_, built});
  }
  known_ = true;
}

template void NGrid<Cell>::maintain(Queue&, Cell*, uint32_t*, const uint32_t*);
template void NGrid<Cell3>::maintain(Queue&, Cell3*, uint32_t*, const uint32_t*);
template void NGrid<Cell>::settle(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::settle(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::sortRows(Queue&, Cell*, uint32_t*, const uint32_t*, bool);
template void NGrid<Cell3>::sortRows(Queue&, Cell3*, uint32_t*, const uint32_t*, bool);
template void NGrid<Cell>::findReach(Queue&, bool, const uint32_t*);
template void NGrid<Cell3>::findReach(Queue&, bool, const uint32_t*);

}  // namespace gw::GW_DEVICE
