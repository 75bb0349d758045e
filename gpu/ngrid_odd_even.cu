// Partial odd-even transposition (Habermann 1972; the thesis's partial sort): a tick makes one odd and one even
// pass along each axis. A pass compares neighbouring cells of a line in pairs that share no cell, so its
// result does not depend on who goes first.
//
//   odd    0 [1 2] [3 4] [5 6] 7          even    [0 1] [2 3] [4 5] [6 7]
#include "gpu/line_sort.h"
#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one pair of neighbouring cells, put in order.
template <class Less>
struct ComparePairs {
  Cell* cells;
  const uint32_t* hold;
  uint32_t lines;           // items go through the lines first: neighbours in memory when those are columns
  uint32_t toLine, toNext;  // cells from one line to the next, from one cell of a line to the next
  uint32_t odd;             // 1: pairs start at the second cell

  GW_BODY void operator()(uint32_t i) const {
    if (hold && *hold) return;
    Cell* first = cells + i % lines * toLine + (i / lines * 2 + odd) * toNext;
    const Cell a = first[0], b = first[toNext];
    if (!Less{}(b, a)) return;
    first[0] = b;
    first[toNext] = a;
  }
};

// One item: one cell.
struct IndexCells {
  uint32_t* cellOf;
  const Cell* cells;
  GW_BODY void operator()(uint32_t i) const { cellOf[cells[i].id] = i; }
};

}  // namespace

void NGrid::transpose(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  const uint32_t columns = dimensions_.columns, rows = dimensions_.rows;
  for (const uint32_t odd : {1u, 0u}) {
    forEach(queue, Count{columns * ((rows - odd) / 2)}, ComparePairs<ByY>{d_cells, d_hold, columns, 1, columns, odd});
  }
  for (const uint32_t odd : {1u, 0u}) {
    forEach(queue, Count{rows * ((columns - odd) / 2)}, ComparePairs<ByX>{d_cells, d_hold, rows, columns, 1, odd});
  }
  forEach(queue, Count{dimensions_.cells()}, IndexCells{d_cellOf, d_cells});
}

}  // namespace gw::GW_DEVICE
