// Packing: entities into rows by counting. Levels of y put them in order well enough to cut that order into rows; then
// each row is put into the parts of x that its index is made of. In 3D levels of z make slabs first. Every sort is
// stable, so the arrangement is unique on every device.
//
//   y ─ level ─ 32 for a row        row   parts of x   0  | 1    | 2  | 3
//     ┄┄┄┄┄┄┄┄┄┄┄ row 1                   columns     0 1 | 2 3 4|    | 5 6
//     ───────────                         first column 0    2     5    5     7
//     ┄┄┄┄┄┄┄┄┄┄┄ row 0
#include <stdexcept>

#include "gpu/neighbour.h"
#include "gpu/ngrid.h"
#include "gpu/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

// Which of `levels` equal parts of the interval; what lies outside counts to the outermost.
GW_FN uint32_t levelOf(float place, Interval all, uint32_t levels) {
  const float height = all.high - all.low, last = float(int32_t(levels - 1));
  const float level = height > 0.0f ? (place - all.low) * (float(int32_t(levels)) / height) : 0.0f;
  return uint32_t(int32_t(level > 0.0f ? (level < last ? level : last) : 0.0f));
}

// One item: one cell.
template <class CellT>
struct LevelOfZ {
  const CellT* cells;
  const GridTotals* totals;
  uint32_t levels;
  GW_BODY uint32_t operator()(uint32_t i) const {
    const CellT cell = cells[i];
    return isLiving(cell.x) ? levelOf(heightOf(placeOf(cell)), totals->z, levels) : levels;
  }
};

// The dead are behind all the living of their slab.
template <class CellT>
struct LevelOfY {
  const CellT* cells;
  const GridTotals* totals;
  uint32_t levels, slabCells;  // of a slab
  GW_BODY uint32_t operator()(uint32_t i) const {
    const CellT cell = cells[i];
    const uint32_t slab = i / slabCells;
    if (!isLiving(cell.x)) return (slab + 1) * levels;  // as the first level of the next slab, of which they come first
    return slab * levels + levelOf(cell.y, totals->y, levels);
  }
};

template <class CellT>
struct MoveCell {
  CellT* out;
  const CellT* in;
  GW_BODY void operator()(uint32_t from, uint32_t to) const { out[to] = in[from]; }
};

// One team: one row, put into parts of x, each part in the order it had; then what there is to know of it, and where
// each id now stands.
template <class CellT>
struct SplitRows {
  static constexpr uint32_t kLanes = kLineLanes;
  static constexpr uint32_t kMostParts = kLongestLine + kLongestLine / 2;
  static constexpr uint32_t kColumnBits = 11;  // of a key on cuda: part, then column
  static_assert(1u << kColumnBits == kLongestLine);
  struct Shared {
    CellT line[kLongestLine];
#if GW_ON_CUDA
    uint32_t keys[kLongestLine];
#else
    uint32_t part[kLongestLine], next[kMostParts + 1];
#endif
    LivingBox box[kLanes];
  };
  CellT* cells;
  const CellT* from;  // may be the same
  uint32_t* cellOf;
  RowsFound found;
  uint32_t columns;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t begin = team.index * columns;
    team.phase([&](uint32_t lane) {
      LivingBox box = LivingBox::nothing();
      for (uint32_t c = lane; c < columns; c += kLanes) {
        s.line[c] = from[begin + c];
        box.take(s.line[c]);
      }
      s.box[lane] = box;
    });
    place(team, s, scaleOf(found.before->x, found.parts), begin);
    joinBoxes<kLanes>(team, s.box);
    team.phase([&](uint32_t lane) {
      if (lane == 0) writeRow(found, team.index, s.box[0]);
    });
  }

  GW_BODY void put(const CellT& cell, uint32_t to, uint32_t& moved) const {
    moved += cellOf[cell.id] != to;
    cells[to] = cell;
    cellOf[cell.id] = to;
  }

#if GW_ON_CUDA
  template <class Team>
  GW_BODY void place(const Team& team, Shared& s, Scale scale, uint32_t begin) const {
    uint16_t* const firstColumn = found.firstColumn + size_t(team.index) * (found.parts + 1);
    uint32_t padded = 1;
    while (padded < columns) padded *= 2;
    team.phase([&](uint32_t lane) {
      for (uint32_t c = lane; c < padded; c += kLanes) {
        const uint32_t part =
            c < columns && isLiving(s.line[c].x) ? partOf(scale, found.parts, s.line[c].x) : found.parts;
        s.keys[c] = c < columns ? part << kColumnBits | c : 0xFFFFFFFFu;
      }
    });
    for (uint32_t run = 2; run <= padded; run *= 2) {
      for (uint32_t step = run / 2; step > 0; step /= 2) {
        team.phase([&](uint32_t lane) {
          for (uint32_t i = lane; i < padded; i += kLanes) {
            const uint32_t partner = i ^ step, mine = s.keys[i];
            if (partner <= i) continue;
            const uint32_t other = s.keys[partner];
            if ((other < mine) != ((i & run) == 0)) continue;
            s.keys[i] = other;
            s.keys[partner] = mine;
          }
        });
      }
    }
    team.phase([&](uint32_t lane) {
      uint32_t moved = 0;
      const auto partAt = [&](uint32_t c) { return s.keys[c] >> kColumnBits; };
      for (uint32_t c = lane; c < columns; c += kLanes) {
        put(s.line[s.keys[c] & (kLongestLine - 1)], begin + c, moved);
        for (uint32_t p = c == 0 ? 0 : partAt(c - 1) + 1; p <= partAt(c); ++p) firstColumn[p] = uint16_t(c);
        if (c + 1 == columns) {
          for (uint32_t p = partAt(c) + 1; p <= found.parts; ++p) firstColumn[p] = uint16_t(columns);
        }
      }
      s.box[lane].moved = moved;
    });
  }
#else
  template <class Team>
  void place(const Team& team, Shared& s, Scale scale, uint32_t begin) const {
    uint16_t* const firstColumn = found.firstColumn + size_t(team.index) * (found.parts + 1);
    const uint32_t parts = found.parts;
    std::fill(s.next, s.next + parts + 1, 0u);
    for (uint32_t c = 0; c < columns; ++c) {
      const float x = s.line[c].x;
      s.part[c] = isLiving(x) ? partOf(scale, parts, x) : parts;
    }
    for (uint32_t c = 0; c < columns; ++c) ++s.next[s.part[c]];
    uint32_t at = 0;
    for (uint32_t p = 0; p <= parts; ++p) {
      const uint32_t count = s.next[p];
      firstColumn[p] = uint16_t(at);
      s.next[p] = begin + at;
      at += count;
    }
    uint32_t moved = 0;
    for (uint32_t c = 0; c < columns; ++c) put(s.line[c], s.next[s.part[c]]++, moved);
    s.box[0].moved = moved;
  }
#endif
};

}  // namespace

template <class CellT>
void NGrid<CellT>::pack(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  requireBuffers(d_cells, d_cellOf);
  requirePacked();
  if (!known_) throw std::logic_error("pack() goes by what is known of the rows; call rebuild() once before.");
  const CellT* from = d_cells;
  CellT* to = aside_.data();
  if (!kFlat<CellT>) {
    byZ_.run(queue, LevelOfZ<CellT>{from, totals_.data(), dimensions_.slabs * kLevelsPerLine},
             MoveCell<CellT>{to, from});
    from = aside_.data();
    to = d_cells;
  }
  byY_.run(
      queue,
      LevelOfY<CellT>{from, totals_.data(), dimensions_.rows * kLevelsPerLine, dimensions_.columns * dimensions_.rows},
      MoveCell<CellT>{to, from});
  splitRows(queue, d_cells, to, d_cellOf, true);
}

template <class CellT>
void NGrid<CellT>::refresh(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  requireBuffers(d_cells, d_cellOf);
  requirePacked();
  splitRows(queue, d_cells, d_cells, d_cellOf, false);
}

template <class CellT>
void NGrid<CellT>::requirePacked() const {
  if (kept_ != Kept::packed) {
    throw std::logic_error("pack() and refresh() need a grid made with Kept::packed.");
  }
}

template <class CellT>
void NGrid<CellT>::splitRows(Queue& queue, CellT* d_cells, const CellT* d_from, uint32_t* d_cellOf, bool built) {
  forEachTeam(queue, dimensions_.lines(), SplitRows<CellT>{d_cells, d_from, d_cellOf, found(), dimensions_.columns});
  findReach(queue, built, nullptr);
  rounds_ = 1;
}

template void NGrid<Cell>::pack(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::pack(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::refresh(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::refresh(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::splitRows(Queue&, Cell*, const Cell*, uint32_t*, bool);
template void NGrid<Cell3>::splitRows(Queue&, Cell3*, const Cell3*, uint32_t*, bool);

}  // namespace gw::GW_DEVICE
