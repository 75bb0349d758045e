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
// lines are kept (docs/thesis-preset.md has figures). So the arrangement of the cells is felt, and is part
// of the state of whatever is computed with it. Exact gathering is row_gather.h.
//
// Both need only the cells, not what maintain() knows of the rows: any upkeep will do, and so will none.
// Results are the same on every device and in any order of visits. An asker stands in the grid: there is
// no search from a place in the world.
#pragma once

#include "gpu/neighbour.h"
#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {

// Cells from `first` to `last`, both included, along each axis.
struct Window {
  uint32_t firstColumn, lastColumn, firstRow, lastRow;
};

// Visits the neighbours of `at` in the window that stand in cell `begin` or later; returns pair tests. The
// dead are passed over and not counted.
template <class Visitor>
GW_MEMBER uint32_t visitWindow(const NGridView& grid, const Window& window, uint32_t begin, Float2 at, float radius,
                               Visitor&& visit) {
  uint32_t tested = 0;
  for (uint32_t row = window.firstRow; row <= window.lastRow; ++row) {
    const uint32_t end = row * grid.columns + window.lastColumn + 1;
    for (uint32_t i = larger(begin, row * grid.columns + window.firstColumn); i < end; ++i) {
      const Cell cell = grid.cells[i];
      if (!isLiving(cell.x)) continue;
      const Float2 away = placeOf(cell) - at;
      ++tested;
      if (isNeighbour(away, radius)) visit(cell, i, away);
    }
  }
  return tested;
}

// The extended Moore neighbourhood: up to nRadius cells away along each axis, cut off at the grid's edges.
// Symmetric: whom I see sees me at the same radius. O((2 nRadius + 1)^2) per query whatever the radius, which is
// why recall falls when more neighbours lie within it than fit into the window.
struct FixedGather {
  NGridView grid;
  uint32_t nRadius = 4;  // the thesis's

  // Calls visit(cell, index, away) for each neighbour found of `at`, the place of the asker in cell
  // `index`, itself included. Returns pair tests. The order of visits must not matter. radius in (0, infinity).
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index), 0, at, radius, visit);
  }

  // The same, but only what stands in a later cell.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index), index + 1, at, radius, visit);
  }

 private:
  GW_MEMBER Window windowOf(uint32_t index) const {
    const uint32_t column = index % grid.columns, row = index / grid.columns;
    return {column - smaller(column, nRadius), column + smaller(grid.columns - 1 - column, nRadius),
            row - smaller(row, nRadius), row + smaller(grid.rows - 1 - row, nRadius)};
  }
};

// Each of the four directions grows from the asker's cell, cell by cell, until the distance along its axis
// passes the radius (in the rounded difference of the neighbour test) or the grid ends; a dead cell, at
// infinity, passes it. Not symmetric: two windows may disagree about a pair. O(extents + cells spanned) per
// query: about as many cells as there are entities within a square of twice the radius, and the whole grid
// at worst, when all stand within the radius.
struct AdaptiveGather {
  NGridView grid;

  // As FixedGather.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index, at, radius), 0, at, radius, visit);
  }

  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return visitWindow(grid, windowOf(index, at, radius), index + 1, at, radius, visit);
  }

 private:
  GW_MEMBER Window windowOf(uint32_t index, Float2 at, float radius) const {
    const uint32_t column = index % grid.columns, row = index / grid.columns;
    const Cell* line = grid.cells + row * grid.columns;
    const Cell* pole = grid.cells + column;
    Window w{column, column, row, row};
    while (w.firstColumn > 0 && magnitude(line[w.firstColumn - 1].x - at.x) <= radius) --w.firstColumn;
    while (w.lastColumn + 1 < grid.columns && magnitude(line[w.lastColumn + 1].x - at.x) <= radius) ++w.lastColumn;
    while (w.firstRow > 0 && magnitude(pole[(w.firstRow - 1) * grid.columns].y - at.y) <= radius) --w.firstRow;
    while (w.lastRow + 1 < grid.rows && magnitude(pole[(w.lastRow + 1) * grid.columns].y - at.y) <= radius) ++w.lastRow;
    return w;
  }
};

}  // namespace gw::GW_DEVICE
