// Packing: entities into rows by counting. Levels of y put them in order well enough to cut that order into rows; then
// each row is put into the parts of x that its index is made of. In 3D levels of z make slabs first. Every sort is
// stable, so the arrangement is unique on every device.
//
//   y ─ level ─ 32 for a row        row   parts of x   0  | 1    | 2  | 3
//     ┄┄┄┄┄┄┄┄┄┄┄ row 1                   columns     0 1 | 2 3 4|    | 5 6
//     ───────────                         first column 0    2     5    5     7
//     ┄┄┄┄┄┄┄┄┄┄┄ row 0
#include <gpuwars/neighbour.h>
#include <gpuwars/ngrid.h>

#include <stdexcept>

#include "detail/ngrid_keep_rows.h"
#include "detail/ngrid_rows.h"

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
  withTeamFor(dimensions_.columns, [&](auto team) {
    const KeepRows<CellT, decltype(team), PartedRows> keep{
        d_cells, d_from, d_cellOf, findReach(built), arrived_.data(), nullptr, rowsOf(dimensions_)};
    forEachTeam(queue, keep.teams(), keep);
  });
  known_ = true;
  rounds_ = 1;
}

template void NGrid<Cell>::pack(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::pack(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::refresh(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::refresh(Queue&, Cell3*, uint32_t*);
template void NGrid<Cell>::splitRows(Queue&, Cell*, const Cell*, uint32_t*, bool);
template void NGrid<Cell3>::splitRows(Queue&, Cell3*, const Cell3*, uint32_t*, bool);

}  // namespace gw::GW_DEVICE
