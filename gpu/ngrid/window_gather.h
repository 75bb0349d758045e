// Windowed gathering in an NGrid, as in Joselli's thesis (2013, chapter 4): the asker looks at the cells
// around its own, because in a well kept grid its neighbours in the world stand near it.
//
//   fixed, N-radius 2            adaptive
//   . . . . . . .                . . . . . . .
//   . o o o o o .                . . o o o . .   up, down: as far as the asker's column stays within the radius
//   . o o # o o .                . . o # o . .   left, right: as far as its row does
//   . o o o o o .                . . o o o . .   then all that these four extents span
//   . . . . . . .                . . o o o . .
//
// Guarantees: what is visited passes isNeighbour(), so nothing that is no neighbour is ever found, and nothing
// is found twice. It is *inexact*: a neighbour outside the window is missed; recall depends on how well the
// lines are kept (docs/results/thesis-preset.md has figures). So results depend on the arrangement of the cells,
// which is part of the state of whatever is computed with it. Exact gathering is row_gather.h.
//
// In 3D poles are looked along as columns are. Both need only the cells, not what maintain() knows of the rows: any
// upkeep will do, and so will none. Results are the same on every device and in any order of visits. An asker stands in
// the grid: there is no search from a place in the world.
#pragma once

#include <gpuwars/neighbour.h>
#include <gpuwars/ngrid.h>

namespace gw::GW_DEVICE {

// Cells from `first` to `last`, both included, along each axis.
struct Window {
  uint32_t firstColumn, lastColumn, firstRow, lastRow, firstSlab, lastSlab;  // slabs: 0 in 2D
};

// Cells to look at in each direction, one number per axis (the thesis's property 7).
struct NRadius {
  uint32_t x = 4, y = 4, z = 4;  // cells
};

// Visits the neighbours of `at` in the window that stand in cell `begin` or later; returns pair tests. The
// dead are passed over and not counted.
template <class CellT, class Visitor>
GW_MEMBER uint32_t visitWindow(const NGridView<CellT>& grid, const Window& window, uint32_t begin, PlaceOf<CellT> at,
                               float radius, Visitor&& visit) {
  uint32_t tested = 0;
  for (uint32_t slab = window.firstSlab; slab <= window.lastSlab; ++slab) {
    for (uint32_t row = window.firstRow; row <= window.lastRow; ++row) {
      const uint32_t line = (slab * grid.rows + row) * grid.columns, end = line + window.lastColumn + 1;
      for (uint32_t i = larger(begin, line + window.firstColumn); i < end; ++i) {
        const CellT cell = grid.cells[i];
        if (!isLiving(cell.x)) continue;
        const PlaceOf<CellT> away = placeOf(cell) - at;
        ++tested;
        if (isNeighbour(away, radius)) visit(cell, i, away);
      }
    }
  }
  return tested;
}

// The extended Moore neighbourhood: up to nRadius cells away along each axis, cut off at the grid's edges.
// Symmetric: a pair finds each other at the same radius or not at all. O(product of 2 nRadius + 1) per query whatever
// the radius, which is why recall falls when more neighbours lie within it than fit into the window.
template <class CellT>
struct FixedGather {
  NGridView<CellT> grid;  // NGrid::view()
  NRadius nRadius{};      // four, the thesis's

  // Calls visit(cell, index, away) for each neighbour found of `at`, the place of the asker in cell
  // `index`, itself included. Returns pair tests. The order of visits must not matter. radius in [0, infinity].
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index), 0, at, radius, visit);
  }

  // The same, but only what stands in a later cell.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index), index + 1, at, radius, visit);
  }

 private:
  GW_MEMBER Window windowOf(uint32_t index) const {
    const uint32_t column = index % grid.columns, line = index / grid.columns;
    const uint32_t row = kFlat<CellT> ? line : line % grid.rows, slab = kFlat<CellT> ? 0 : line / grid.rows;
    return {column - smaller(column, nRadius.x), column + smaller(grid.columns - 1 - column, nRadius.x),
            row - smaller(row, nRadius.y),       row + smaller(grid.rows - 1 - row, nRadius.y),
            slab - smaller(slab, nRadius.z),     slab + smaller(grid.slabs - 1 - slab, nRadius.z)};
  }
};
// Of a view, with an N-radius or without.
template <class CellT, class... Rest>
FixedGather(NGridView<CellT>, Rest...) -> FixedGather<CellT>;

// Each direction along each axis grows from the asker's cell, cell by cell, until the distance along that axis
// passes the radius (in the rounded difference of the neighbour test) or the grid ends; a dead cell, at
// infinity, passes it. Not symmetric: two windows may disagree about a pair. O(extents + cells spanned) per
// query: about as many cells as there are entities within a square of twice the radius, and the whole grid
// at worst, when all stand within the radius.
template <class CellT>
struct AdaptiveGather {
  NGridView<CellT> grid;  // NGrid::view()

  // As FixedGather.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index, at, radius), 0, at, radius, visit);
  }

  // As FixedGather.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index, at, radius), index + 1, at, radius, visit);
  }

 private:
  GW_MEMBER Window windowOf(uint32_t index, PlaceOf<CellT> at, float radius) const {
    const uint32_t column = index % grid.columns, line = index / grid.columns, slabCells = grid.columns * grid.rows;
    const uint32_t row = kFlat<CellT> ? line : line % grid.rows, slab = kFlat<CellT> ? 0 : line / grid.rows;
    const CellT* along = grid.cells + line * grid.columns;          // the asker's row
    const CellT* upright = grid.cells + slab * slabCells + column;  // its column
    Window w{column, column, row, row, slab, slab};
    while (w.firstColumn > 0 && magnitude(along[w.firstColumn - 1].x - at.x) <= radius) --w.firstColumn;
    while (w.lastColumn + 1 < grid.columns && magnitude(along[w.lastColumn + 1].x - at.x) <= radius) ++w.lastColumn;
    while (w.firstRow > 0 && magnitude(upright[(w.firstRow - 1) * grid.columns].y - at.y) <= radius) --w.firstRow;
    while (w.lastRow + 1 < grid.rows && magnitude(upright[(w.lastRow + 1) * grid.columns].y - at.y) <= radius) {
      ++w.lastRow;
    }
    if constexpr (!kFlat<CellT>) {
      const CellT* pole = grid.cells + row * grid.columns + column;
      while (w.firstSlab > 0 && magnitude(pole[(w.firstSlab - 1) * slabCells].z - at.z) <= radius) --w.firstSlab;
      while (w.lastSlab + 1 < grid.slabs && magnitude(pole[(w.lastSlab + 1) * slabCells].z - at.z) <= radius) {
        ++w.lastSlab;
      }
    }
    return w;
  }
};
// Of a view.
template <class CellT>
AdaptiveGather(NGridView<CellT>) -> AdaptiveGather<CellT>;

}  // namespace gw::GW_DEVICE
