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
        const bool lives = isLiving(cell.x);
        LivingBox::grow(box.y, cell.y, lives);
        if constexpr (!kFlat<CellT>) LivingBox::grow(box.z, cell.z, lives);
        box.living += lives;
      }
      s.box[lane] = box;
    });
    joinBoxes<kLanes>(team, s.box);
    team.phase([&](uint32_t lane) {
      if (lane != 0) return;
      LivingBox& box = s.box[0];  // the living are the first of a sorted row
      if (box.living) box.x = {line[0].x, line[box.living - 1].x};
      writeRow(found, team.index, box);
    });
    team.phase([&](uint32_t lane) { indexRow(team.index, line, lane, s.box[0]); });
  }

  // Lane by lane: the parts of x that begin at each living cell, then those after the last.
  GW_BODY void indexRow(uint32_t line, const CellT* cell, uint32_t lane, const LivingBox& box) const {
    const GridRow row = box.row(found.parts);
    const uint32_t count = box.living;
    uint16_t* starts = found.starts + size_t(line) * (found.parts + 1);
    for (uint32_t c = lane; c <= count; c += kLanes) {
      const uint32_t first = c == 0 ? 0 : partOf(row, found.parts, cell[c - 1].x) + 1;
      const uint32_t last = c == count ? found.parts : partOf(row, found.parts, cell[c].x);
      for (uint32_t p = first; p <= last; ++p) starts[p] = uint16_t(c);
    }
  }
};

// One team: of one slab, the running maximum of `high` and the running minimum, from behind, of `low` over its rows.
// Of a single slab also what is known of the whole grid.
struct FindReach {
  static constexpr uint32_t kLanes = 64;
  struct Shared {
    Interval reach[kLanes], z[kLanes];
    float height[kLanes];
    uint32_t moved[kLanes];
  };
  Interval* reach;
  GridTotals *slabTotals, *totals;  // [slabs], of each; of all
  RowsFound found;
  uint32_t rows, slabs, built;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t each = (rows + kLanes - 1) / kLanes, base = team.index * rows;
    team.phase([&](uint32_t lane) {
      Interval y{kInfinity, -kInfinity}, z{kInfinity, -kInfinity};
      float height = 0.0f;
      uint32_t moved = 0;
      for (uint32_t row = lane * each; row < (lane + 1) * each && row < rows; ++row) {
        const GridRow line = found.line[base + row];
        y = {smaller(y.low, line.low), larger(y.high, line.high)};
        if (found.depth)
          z = {smaller(z.low, found.depth[base + row].low), larger(z.high, found.depth[base + row].high)};
        if (line.high > line.low) height += line.high - line.low;
        moved += found.moved[base + row];
      }
      s.reach[lane] = y;
      s.z[lane] = z;
      s.height[lane] = height;
      s.moved[lane] = moved;
    });
    team.phase([&](uint32_t lane) {
      float most = -kInfinity, least = kInfinity;
      for (uint32_t l = 0; l < lane; ++l) most = larger(most, s.reach[l].high);
      for (uint32_t l = lane + 1; l < kLanes; ++l) least = smaller(least, s.reach[l].low);
      if (lane == 0) writeTotals(team.index, s);
      const uint32_t begin = lane * each, end = smaller((lane + 1) * each, rows);
      for (uint32_t row = begin; row < end; ++row) {
        reach[base + row].high = most = larger(most, found.line[base + row].high);
      }
      for (uint32_t row = end; row > begin; --row) {
        reach[base + row - 1].low = least = smaller(least, found.line[base + row - 1].low);
      }
    });
  }

  GW_BODY void writeTotals(uint32_t slab, const Shared& s) const {
    GridTotals all{0.0f, 0.0f, {kInfinity, -kInfinity}, {kInfinity, -kInfinity}, 0};
    for (uint32_t l = 0; l < kLanes; ++l) {
      all.height += s.height[l];
      all.y = {smaller(all.y.low, s.reach[l].low), larger(all.y.high, s.reach[l].high)};
      all.z = {smaller(all.z.low, s.z[l].low), larger(all.z.high, s.z[l].high)};
      all.moved += s.moved[l];
    }
    if (slabs == 1) {
      all.heightBuilt = built ? all.height : totals->heightBuilt;
      *totals = all;
    }
    if (slabTotals) slabTotals[slab] = all;
  }
};

// One team in all: the same over slabs.
struct FindSlabReach {
  static constexpr uint32_t kLanes = 1;
  struct Shared {};
  Interval* reach;  // [slabs]
  GridTotals* totals;
  const GridTotals* slabTotals;
  uint32_t slabs, built;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared&) const {
    team.phase([&](uint32_t) {
      GridTotals all{0.0f, 0.0f, {kInfinity, -kInfinity}, {kInfinity, -kInfinity}, 0};
      for (uint32_t slab = 0; slab < slabs; ++slab) {
        const GridTotals mine = slabTotals[slab];
        all.height += mine.height;
        all.y = {smaller(all.y.low, mine.y.low), larger(all.y.high, mine.y.high)};
        all.z = {smaller(all.z.low, mine.z.low), larger(all.z.high, mine.z.high)};
        all.moved += mine.moved;
        reach[slab].high = all.z.high;
      }
      float least = kInfinity;
      for (uint32_t slab = slabs; slab > 0; --slab) {
        reach[slab - 1].low = least = smaller(least, slabTotals[slab - 1].z.low);
      }
      all.heightBuilt = built ? all.height : totals->heightBuilt;
      *totals = all;
    });
  }
};

}  // namespace

void requireBuffers(const void* d_cells, const void* d_cellOf) {
  if (!d_cells) throw std::invalid_argument("d_cells is null; give the grid a buffer with a cell for each of its own.");
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
  const RowsFound found{line_.data(), depth_.data(), living_.data(), moved_.data(), starts_.data(), parts_};
  forEachTeam(queue, dimensions_.lines(), SortRows<CellT>{d_cells, d_cellOf, found, d_hold, dimensions_.columns});
  findReach(queue, built);
}

template <class CellT>
void NGrid<CellT>::findReach(Queue& queue, bool built) {
  const uint32_t slabs = dimensions_.slabs;
  const RowsFound found{line_.data(), depth_.data(), living_.data(), moved_.data(), starts_.data(), parts_};
  forEachTeam(queue, slabs,
              FindReach{reach_.data(), slabTotals_.data(), totals_.data(), found, dimensions_.rows, slabs, built});
  if (!kFlat<CellT>) {
    forEachTeam(queue, 1, FindSlabReach{slabReach_.data(), totals_.data(), slabTotals_.data(), slabs, built});
  }
  known_ = true;
}

template void NGrid<Cell>::maintain(Queue&, Cell*, uint32_t*, const uint32_t*);
template void NGrid<Cell3>::maintain(Queue&, Cell3*, uint32_t*, const uint32_t*);
template void NGrid<Cell>::settle(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::settle(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::sortRows(Queue&, Cell*, uint32_t*, const uint32_t*, bool);
template void NGrid<Cell3>::sortRows(Queue&, Cell3*, uint32_t*, const uint32_t*, bool);
template void NGrid<Cell>::findReach(Queue&, bool);
template void NGrid<Cell3>::findReach(Queue&, bool);

}  // namespace gw::GW_DEVICE
