// A plain gather by rows with one mistake each: the checker of row_gather_test has to catch them all. Each is a mistake
// that someone would make when writing it.
#pragma once

#include "gpu/row_gather.h"
#include "tests/gpu/probes.h"

namespace gw::GW_DEVICE {

template <test::Method kMistake>
struct BrokenGather {
  NGridView grid;

  template <class Visitor>
  GW_MEMBER uint32_t operator()(float x, float y, float radius, Visitor&& visit) const {
    uint32_t tested = 0, rows = grid.rows;
    // Leaves out the last row that has anyone in it.
    if (kMistake == test::Method::forgetsLastRow) {
      while (rows > 0 && grid.living[rows - 1] == 0) --rows;
      if (rows > 1) --rows;
    }
    for (uint32_t row = rows; row-- > 0;) {
      // Takes the rows' upper ends for ascending, which the dead among the living undo.
      if (kMistake == test::Method::trustsRowOrder && y - grid.high[row] > radius) break;
      if (grid.low[row] - y > radius || y - grid.high[row] > radius) continue;
      const Cell* line = grid.cells + row * grid.columns;
      for (uint32_t c = 0; c < grid.living[row]; ++c) {
        // Prunes by an edge that was rounded on its own, not by the rounded difference.
        if (kMistake == test::Method::prunesByEdge && line[c].x < x - radius) continue;
        const float dx = line[c].x - x, dy = line[c].y - y;
        // Takes the boundary itself for outside.
        if (kMistake == test::Method::stopsBeforeBoundary && dx >= radius) break;
        ++tested;
        if (isNeighbour(dx, dy, radius)) visit(line[c], row * grid.columns + c, dx, dy);
      }
    }
    return tested;
  }
};

}  // namespace gw::GW_DEVICE
