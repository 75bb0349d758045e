// Exact gathering in an NGrid: precisely the neighbours that brute force finds, however misaligned the
// columns are. Needs only what maintain() guarantees: rows in ascending x, and each row's interval of y.
//
//        high[row] ┌───────────────┐        visit the rows whose interval meets [y - r, y + r],
//   y + r ─ ─ ─ ─ ─│─ ─┌───┐─ ─ ─ ─│        and in such a row the one span of columns whose x
//                  │   │ ■ │       │        lies in [x - r, x + r], found by an index
//   y - r ─ ─ ─ ─ ─│─ ─└───┘─ ─ ─ ─│
//         low[row] └───────────────┘
//
// All pruning uses the rounded differences of the neighbour test itself: rounding is monotonic, so what is
// pruned would have failed the test. Cost per query: the rows met, in each O(log columns) at worst, and the spans.
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
    return visitRows(rowsFrom(nearestRow(at.y), at.y, radius), at, radius, visit);
  }

  // The same for an asker that stands in the grid itself, in cell `index`: near there the rows are looked for.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return visitRows(rowsFrom(index / grid.columns, at.y, radius), at, radius, visit);
  }

  // The same, but only what stands in a cell after `index`: over all cells each pair is found once, from one side,
  // for half the tests. `at` is the asker's place, in its cell or elsewhere: where it will be, say.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    const uint32_t row = index / grid.columns;
    Rows rows = rowsFrom(row, at.y, radius);
    rows.begin = larger(rows.begin, row + 1);
    const uint32_t tested = visitSpan(row, index % grid.columns + 1, at, radius, visit);
    return tested + visitRows(rows, at, radius, visit);
  }

 private:
  struct Rows {
    uint32_t begin, end;
  };

  template <class Visitor>
  GW_MEMBER uint32_t visitRows(Rows rows, Float2 at, float radius, Visitor&& visit) const {
    uint32_t tested = 0;
    for (uint32_t row = rows.begin; row < rows.end; ++row) {
      if (grid.low[row] - at.y > radius || at.y - grid.high[row] > radius) continue;
      tested += visitSpan(row, firstColumn(row, at.x, radius), at, radius, visit);
    }
    return tested;
  }

  // The columns of one row from `begin` to the end of the span.
  template <class Visitor>
  GW_MEMBER uint32_t visitSpan(uint32_t row, uint32_t begin, Float2 at, float radius, Visitor&& visit) const {
    const Cell* line = grid.cells + row * grid.columns;
    const uint32_t end = endColumn(row, at.x, radius);
    for (uint32_t c = begin; c < end; ++c) {
      const Float2 away = placeOf(line[c]) - at;
      if (isNeighbour(away, radius)) visit(line[c], row * grid.columns + c, away);
    }
    return end > begin ? end - begin : 0;
  }

  // The rows that may meet [y - radius, y + radius], walking from one of them or one near by.
  GW_MEMBER Rows rowsFrom(uint32_t row, float y, float radius) const {
    uint32_t begin = row, end = row + 1;
    while (begin < grid.rows && y - grid.reachHigh[begin] > radius) ++begin;
    while (begin > 0 && !(y - grid.reachHigh[begin - 1] > radius)) --begin;
    while (end > 0 && grid.reachLow[end - 1] - y > radius) --end;
    while (end < grid.rows && !(grid.reachLow[end] - y > radius)) ++end;
    return {begin, end};
  }

  // The first row that reaches up to y, or the last.
  GW_MEMBER uint32_t nearestRow(float y) const {
    uint32_t begin = 0, count = grid.rows;
    while (count > 1) {
      const uint32_t half = count / 2;
      begin += grid.reachHigh[begin + half - 1] < y ? half : 0;
      count -= half;
    }
    return begin;
  }

  // What is neighbour may round: edges are widened by more than that.
  GW_MEMBER static float roundingOf(float x, float radius) { return (magnitude(x) + radius) * 0x1p-20f; }

  // The index says in which few columns the span begins; bisection, without branches since its steps are equally
  // likely to go either way, makes them fewer.
  GW_MEMBER uint32_t firstColumn(uint32_t row, float x, float radius) const {
    const uint16_t* start =
        grid.starts + row * (grid.buckets + 1) + grid.bucketOf(row, x - radius - roundingOf(x, radius));
    const Cell* line = grid.cells + row * grid.columns;
    uint32_t begin = start[0], count = start[1] - begin;
    while (count > kFew) {
      const uint32_t half = count / 2;
      begin += line[begin + half - 1].x - x < -radius ? half : 0;
      count -= half;
    }
    return begin;
  }

  GW_MEMBER uint32_t endColumn(uint32_t row, float x, float radius) const {
    const uint16_t* start =
        grid.starts + row * (grid.buckets + 1) + grid.bucketOf(row, x + radius + roundingOf(x, radius));
    const Cell* line = grid.cells + row * grid.columns;
    uint32_t begin = start[0], count = start[1] - begin;
    while (count > kFew) {
      const uint32_t half = count / 2;
      begin += line[begin + half - 1].x - x > radius ? 0 : half;
      count -= half;
    }
    return begin + count;
  }

  static constexpr uint32_t kFew = 8;
};

}  // namespace gw::GW_DEVICE
