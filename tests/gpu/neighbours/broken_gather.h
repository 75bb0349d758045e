// A plain gather by rows with one mistake each: the checker of row_gather_test has to catch them all. Each is a mistake
// that someone would make when writing it.
#pragma once

#include "gpu/ngrid/row_gather.h"
#include "tests/gpu/probes.h"

namespace gw::GW_DEVICE {

template <test::Method kMistake>
struct BrokenGather {
  NGridView<Cell> grid;

  template <class Visitor>
  GW_MEMBER uint32_t operator()(Float2 at, float radius, Visitor&& visit) const {
    uint32_t tested = 0, rows = grid.rows;
    // Leaves out the last row that has anyone in it.
    if (kMistake == test::Method::forgetsLastRow) {
      while (rows > 0 && grid.living[rows - 1] == 0) --rows;
      if (rows > 1) --rows;
    }
    for (uint32_t row = rows; row-- > 0;) {
      // Takes the rows' upper ends for ascending, which the dead among the living undo.
      if (kMistake == test::Method::trustsRowOrder && at.y - grid.height[row].high > radius) break;
      if (grid.height[row].low - at.y > radius || at.y - grid.height[row].high > radius) continue;
      const Cell* line = grid.cells + row * grid.columns;
      for (uint32_t c = 0; c < grid.living[row]; ++c) {
        // Prunes by an edge that was rounded on its own, not by the rounded difference.
        if (kMistake == test::Method::prunesByEdge && line[c].x < at.x - radius) continue;
        const Float2 away = placeOf(line[c]) - at;
        // Takes the boundary itself for outside.
        if (kMistake == test::Method::stopsBeforeBoundary && away.x >= radius) break;
        ++tested;
        if (isNeighbour(away, radius)) visit(line[c], row * grid.columns + c, away);
      }
    }
    return tested;
  }
};

}  // namespace gw::GW_DEVICE
