// Partial odd-even transposition (Habermann 1972; the thesis's partial sort): a tick makes one odd and one even
// pass along each axis, four steps in 2D and six in 3D. A pass compares neighbouring cells of a line in pairs that
// share no cell, so its result does not depend on who goes first.
//
//   odd    0 [1 2] [3 4] [5 6] 7          even    [0 1] [2 3] [4 5] [6 7]
#include "gpu/line_sort.h"
#include "gpu/ngrid.h"
#include "gpu/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

// Where the lines of an axis begin, and how they go on.
struct Strides {
  uint32_t length, toNext;           // cells of a line; from one to the next
  uint32_t perPlane, toLine, plane;  // lines of a plane; from one to the next; from one plane to the next
};

// One item: one pair of neighbouring cells, put in order. Items go through the lines of a plane first: neighbours in
// memory when those are columns or poles.
template <class CellT, class Less>
struct ComparePairs {
  CellT* cells;
  const uint32_t* hold;
  uint32_t* moved;  // counted anew
  Strides lines;
  uint32_t odd;  // 1: pairs start at the second cell

  uint32_t pairs(uint32_t planes) const { return lines.perPlane * ((lines.length - odd) / 2) * planes; }

  GW_BODY void operator()(uint32_t i) const {
    if (i == 0) *moved = 0;
    if (hold && *hold) return;
    const uint32_t perPlane = lines.perPlane * ((lines.length - odd) / 2), inPlane = i % perPlane;
    const uint32_t begin = i / perPlane * lines.plane + inPlane % lines.perPlane * lines.toLine;
    CellT* first = cells + begin + (inPlane / lines.perPlane * 2 + odd) * lines.toNext;
    const CellT a = first[0], b = first[lines.toNext];
    if (!Less{}(b, a)) return;
    first[0] = b;
    first[lines.toNext] = a;
  }
};

// One item: one cell.
template <class CellT>
struct IndexCells {
  uint32_t *cellOf, *moved;
  const CellT* cells;
  GW_BODY void operator()(uint32_t i) const {
    const uint32_t id = cells[i].id;
    if (cellOf[id] == i) return;
    cellOf[id] = i;
    atomicAddTo(*moved, 1);  // a sum: in any order
  }
};

template <class CellT, class Less>
void pass(Queue& queue, CellT* d_cells, const uint32_t* d_hold, uint32_t* d_moved, const Strides& lines,
          uint32_t planes) {
  for (const uint32_t odd : {1u, 0u}) {
    const ComparePairs<CellT, Less> compare{d_cells, d_hold, d_moved, lines, odd};
    forEach(queue, Count{compare.pairs(planes)}, compare);
  }
}

}  // namespace

template <class CellT>
void NGrid<CellT>::transpose(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  requireBuffers(d_cells, d_cellOf);
  const uint32_t columns = dimensions_.columns, rows = dimensions_.rows, slabs = dimensions_.slabs;
  const uint32_t slabCells = columns * rows;
  uint32_t* const d_moved = &totals_.data()->moved;
  if (!kFlat<CellT>) pass<CellT, ByZ>(queue, d_cells, d_hold, d_moved, {slabs, slabCells, slabCells, 1, 0}, 1);
  pass<CellT, ByY>(queue, d_cells, d_hold, d_moved, {rows, columns, columns, 1, slabCells}, slabs);
  pass<CellT, ByX>(queue, d_cells, d_hold, d_moved, {columns, 1, rows * slabs, columns, 0}, 1);
  forEach(queue, Count{dimensions_.cells()}, IndexCells<CellT>{d_cellOf, d_moved, d_cells});
  rounds_ = 1;
}

template void NGrid<Cell>::transpose(Queue&, Cell*, uint32_t*, const uint32_t*);
template void NGrid<Cell3>::transpose(Queue&, Cell3*, uint32_t*, const uint32_t*);

}  // namespace gw::GW_DEVICE
