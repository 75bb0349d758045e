// Exact gathering in an NGrid: precisely the neighbours that brute force finds, however misaligned the
// columns are. Needs only what maintain() guarantees: rows in ascending x, and each row's interval of y.
//
//        high[row] ┌───────────────┐        visit the rows whose interval meets [y - r, y + r],
//   y + r ─ ─ ─ ─ ─│─ ─┌───┐─ ─ ─ ─│        and in such a row the one span of columns whose x
//                  │   │ ■ │       │        lies in [x - r, x + r], found by bisection
//   y - r ─ ─ ─ ─ ─│─ ─└───┘─ ─ ─ ─│
//         low[row] └───────────────┘
//
// All pruning uses the rounded differences of the neighbour test itself: rounding is monotonic, so what is
// pruned would have failed the test. Cost per query: O(log rows) + per row met O(log columns) + the span.
#pragma once

#include "gpu/neighbour.h"
#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {

struct RowGather {
  NGridView grid;

  // Calls visit(cell, index, away) for each living neighbour of the place `at` within radius, away from it by
  // `away`; an entity that stands there itself is among them. Returns how many pair tests that took. The order
  // of visits is that of the cells and must not matter. radius in (0, infinity), `at` finite.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(Float2 at, float radius, Visitor&& visit) const {
    return visitRows(firstRow(at.y, radius), at, radius, visit);
  }

  // The same for an asker that stands in the grid itself, in cell `index`: what windowed searches start from
  // (window_gather.h). An exact one finds the same set wherever it starts.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t, Float2 at, float radius, Visitor&& visit) const {
    return (*this)(at, radius, visit);
  }

  // The same, but only what stands in a cell after `index`: over all cells each pair is found once, from one side,
  // for half the tests. `at` is the asker's place, in its cell or elsewhere: where it will be, say.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    const uint32_t row = index / grid.columns;
    const uint32_t tested = visitSpan(row, index % grid.columns + 1, at, radius, visit);
    return tested + visitRows(larger(row + 1, firstRow(at.y, radius)), at, radius, visit);
  }

 private:
  template <class Visitor>
  GW_MEMBER uint32_t visitRows(uint32_t begin, Float2 at, float radius, Visitor&& visit) const {
    uint32_t tested = 0;
    const uint32_t end = endRow(at.y, radius);
    for (uint32_t row = begin; row < end; ++row) {
      if (grid.low[row] - at.y > radius || at.y - grid.high[row] > radius) continue;
      const Cell* line = grid.cells + row * grid.columns;
      tested += visitSpan(row, firstColumn(line, grid.living[row], at.x, radius), at, radius, visit);
    }
    return tested;
  }

  // The columns of one row from `begin` on, until x has left the radius.
  template <class Visitor>
  GW_MEMBER uint32_t visitSpan(uint32_t row, uint32_t begin, Float2 at, float radius, Visitor&& visit) const {
    const Cell* line = grid.cells + row * grid.columns;
    const uint32_t living = grid.living[row];
    uint32_t tested = 0;
    for (uint32_t c = begin; c < living; ++c, ++tested) {
      const Float2 away = placeOf(line[c]) - at;
      if (away.x > radius) break;
      if (isNeighbour(away, radius)) visit(line[c], row * grid.columns + c, away);
    }
    return tested;
  }

  GW_MEMBER uint32_t firstRow(float y, float radius) const {
    uint32_t begin = 0, count = grid.rows;
    while (count > 0) {
      const uint32_t half = count / 2;
      if (y - grid.reachHigh[begin + half] > radius) {
        begin += half + 1;
        count -= half + 1;
      } else {
        count = half;
      }
    }
    return begin;
  }

  GW_MEMBER uint32_t endRow(float y, float radius) const {
    uint32_t begin = 0, count = grid.rows;
    while (count > 0) {
      const uint32_t half = count / 2;
      if (grid.reachLow[begin + half] - y > radius) {
        count = half;
      } else {
        begin += half + 1;
        count -= half + 1;
      }
    }
    return begin;
  }

  // Without branches: the two outcomes of a step are equally likely, so a branch would be mispredicted.
  GW_MEMBER static uint32_t firstColumn(const Cell* line, uint32_t living, float x, float radius) {
    if (living == 0) return 0;
    uint32_t begin = 0, count = living;
    while (count > 1) {
      const uint32_t half = count / 2;
      begin += line[begin + half - 1].x - x < -radius ? half : 0;
      count -= half;
    }
    return begin + (line[begin].x - x < -radius ? 1 : 0);
  }
};

}  // namespace gw::GW_DEVICE
