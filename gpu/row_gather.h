// Exact gathering in an NGrid: precisely the neighbours that brute force finds, however misaligned columns and poles
// are. Needs only what upkeep finds out about rows: their intervals of y (in 3D of z too) and their index of x.
//
//        high[row] ┌───────────────┐        visit the rows whose interval meets [y - r, y + r],
//   y + r ─ ─ ─ ─ ─│─ ─┌───┐─ ─ ─ ─│        and in such a row the one span of columns whose x
//                  │   │ ■ │       │        lies in [x - r, x + r], found by the index;
//   y - r ─ ─ ─ ─ ─│─ ─└───┘─ ─ ─ ─│        in 3D, of the slabs that meet [z - r, z + r]
//         low[row] └───────────────┘
//
// All pruning uses the rounded differences of the neighbour test itself: rounding is monotonic, so what is
// pruned would have failed the test. Cost per query: the rows met, in each O(log columns) at worst, and the spans.
#pragma once

#include "gpu/neighbour.h"
#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {

template <class CellT>
struct RowGather {
  using Place = PlaceOf<CellT>;
  NGridView<CellT> grid;

  // Calls visit(cell, index, away) for each living neighbour of the place `at` within radius, away from it by
  // `away`; an entity that stands there itself is among them. Returns how many pair tests that took. The order
  // of visits is that of the cells and must not matter. radius in [0, infinity], `at` finite.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(Place at, float radius, Visitor&& visit) const {
    uint32_t slab = 0;
    if constexpr (!kFlat<CellT>) slab = nearest(grid.slabReach, grid.slabs, at.z);
    const uint32_t row = nearest(grid.reach + slab * grid.rows, grid.rows, at.y);
    return visitFrom(0, slab * grid.rows + row, at, radius, visit);
  }

  // The same for an asker that stands in the grid itself, in cell `index`: near there the rows are looked for.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t index, Place at, float radius, Visitor&& visit) const {
    return visitFrom(0, index / grid.columns, at, radius, visit);
  }

  // The same, but only what stands in a cell after `index`: over all cells each pair is found once, from one side,
  // for half the tests. `at` is the asker's place, in its cell or elsewhere: where it will be, say.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Place at, float radius, Visitor&& visit) const {
    const uint32_t line = index / grid.columns;
    const uint32_t tested = visitSpan(line, grid.line[line], index % grid.columns + 1, at, radius, visit);
    return tested + visitFrom(line + 1, line, at, radius, visit);
  }

 private:
  // The lines from `first` on that may meet the asker's box, looked for near the line `near`.
  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t first, uint32_t near, Place at, float radius, Visitor&& visit) const {
    if constexpr (kFlat<CellT>) {
      return visitRows(0, first, near, at, radius, visit);
    } else {
      const uint32_t row = near % grid.rows;
      uint32_t tested = 0, slab = firstReaching(grid.slabReach, grid.slabs, near / grid.rows, at.z, radius);
      for (; slab < grid.slabs && !(grid.slabReach[slab].low - at.z > radius); ++slab) {
        const uint32_t base = slab * grid.rows;
        if (first < base + grid.rows)
          tested += visitRows(base, first > base ? first - base : 0, row, at, radius, visit);
      }
      return tested;
    }
  }

  // Those of one slab, whose lines begin at `base`.
  template <class Visitor>
  GW_MEMBER uint32_t visitRows(uint32_t base, uint32_t first, uint32_t near, Place at, float radius,
                               Visitor&& visit) const {
    const Interval* reach = grid.reach + base;
    uint32_t tested = 0, row = larger(firstReaching(reach, grid.rows, near, at.y, radius), first);
    for (; row < grid.rows && !(reach[row].low - at.y > radius); ++row) {
      const GridRow line = grid.line[base + row];
      if (line.low - at.y > radius || at.y - line.high > radius) continue;
      if constexpr (!kFlat<CellT>) {
        const Interval depth = grid.depth[base + row];
        if (depth.low - at.z > radius || at.z - depth.high > radius) continue;
      }
      tested += visitSpan(base + row, line, 0, at, radius, visit);
    }
    return tested;
  }

  // The columns of one line from `begin` on that may be within the radius.
  template <class Visitor>
  GW_MEMBER uint32_t visitSpan(uint32_t row, GridRow line, uint32_t begin, Place at, float radius,
                               Visitor&& visit) const {
    // What is neighbour may round: edges are widened by more than that.
    const float rounding = (magnitude(at.x) + radius) * 0x1p-20f;
    const uint16_t* starts = grid.starts + size_t(row) * (grid.parts + 1);
    const uint16_t* from = starts + partOf(line, grid.parts, at.x - radius - rounding);
    const uint16_t* to = starts + partOf(line, grid.parts, at.x + radius + rounding);
    const CellT* cells = grid.cells + row * grid.columns;
    const uint32_t first = larger(firstColumn(cells, from[0], from[1], at.x, radius), begin);
    const uint32_t end = endColumn(cells, to[0], to[1], at.x, radius);
    for (uint32_t c = first; c < end; ++c) {
      const Place away = placeOf(cells[c]) - at;
      if (isNeighbour(away, radius)) visit(cells[c], row * grid.columns + c, away);
    }
    return end > first ? end - first : 0;
  }

  // The first of `count` rows, or slabs, that reaches up to `place` - radius, walking from one near by. The first step
  // down is as likely as not, so it is taken without a branch.
  GW_MEMBER static uint32_t firstReaching(const Interval* reach, uint32_t count, uint32_t near, float place,
                                          float radius) {
    uint32_t begin = near;
    while (begin < count && place - reach[begin].high > radius) ++begin;
    const uint32_t before = begin > 0 ? begin - 1 : 0;
    begin = place - reach[before].high > radius ? begin : before;
    while (begin > 0 && !(place - reach[begin - 1].high > radius)) --begin;
    return begin;
  }

  // The first that reaches up to `place`, or the last.
  GW_MEMBER static uint32_t nearest(const Interval* reach, uint32_t count, float place) {
    uint32_t begin = 0;
    while (count > 1) {
      const uint32_t half = count / 2;
      begin += reach[begin + half - 1].high < place ? half : 0;
      count -= half;
    }
    return begin;
  }

  // The index says in which few columns a span begins or ends. Of a sorted row bisection makes them fewer, without
  // branches since its steps are equally likely to go either way.
  GW_MEMBER uint32_t firstColumn(const CellT* cells, uint32_t begin, uint32_t end, float x, float radius) const {
    uint32_t count = end - begin;
    while (count > kFew && grid.sorted) {
      const uint32_t half = count / 2;
      begin += cells[begin + half - 1].x - x < -radius ? half : 0;
      count -= half;
    }
    return begin;
  }

  GW_MEMBER uint32_t endColumn(const CellT* cells, uint32_t begin, uint32_t end, float x, float radius) const {
    uint32_t count = end - begin;
    while (count > kFew && grid.sorted) {
      const uint32_t half = count / 2;
      begin += cells[begin + half - 1].x - x > radius ? 0 : half;
      count -= half;
    }
    return begin + count;
  }

  static constexpr uint32_t kFew = 8;
};
template <class CellT>
RowGather(NGridView<CellT>) -> RowGather<CellT>;

}  // namespace gw::GW_DEVICE
