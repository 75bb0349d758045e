// Exact gathering in an NGrid: precisely the neighbours that brute force finds, however misaligned columns and poles
// are. Needs only what upkeep finds out about rows: their intervals of y (in 3D of z too), and where x, y and z begin.
//
//    highest y ┌───────────────┐        visit the rows whose interval meets [y - r, y + r],
//   y + r ─ ─ ─│─ ─┌───┐─ ─ ─ ─│        and in such a row the one span of columns whose x
//              │   │ ■ │       │        lies in [x - r, x + r];
//   y - r ─ ─ ─│─ ─└───┘─ ─ ─ ─│        in 3D, of the slabs that meet [z - r, z + r]
//     lowest y └───────────────┘
//
// All pruning uses the rounded differences of the neighbour test itself: rounding is monotonic, so what is
// pruned would have failed the test. Cost per query: the rows met, in each O(log columns) at worst, and the spans.
#pragma once

#include <gpuwars/neighbour.h>
#include <gpuwars/ngrid.h>

namespace gw::GW_DEVICE {

// The search. Copy it into a kernel by value; it is valid as long as its view.
template <class CellT>
struct RowGather {
  using Place = PlaceOf<CellT>;  // Float2 or Float3
  NGridView<CellT> grid;         // NGrid::view()

  // Calls visit(cell, index, away) for each living neighbour of the place `at` within radius, away from it by
  // `away`; an entity that stands there itself is among them. Returns how many pair tests that took. The order
  // of visits is that of the cells and must not matter. radius in [0, infinity], `at` finite.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(Place at, float radius, Visitor&& visit) const {
    return visitFrom(0, 0, at, radius, visit);
  }

  // The same for an asker that stands in the grid itself, in cell `index`.
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t, Place at, float radius, Visitor&& visit) const {
    return visitFrom(0, 0, at, radius, visit);
  }

  // The same, but only what stands in a cell after `index`: over all cells each pair is found once, from one side,
  // for half the tests. `at` is the asker's place, in its cell or elsewhere: where it will be, say.
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, Place at, float radius, Visitor&& visit) const {
    return visitFrom(index / grid.columns, index % grid.columns + 1, at, radius, visit);
  }

 private:
  // Parts of x in which the spans begin and end.
  struct Span {
    uint32_t from, to;
  };

  // What is neighbour may round: edges are widened by more than that.
  GW_MEMBER static float roundingOf(float place, float radius) { return (magnitude(place) + radius) * 0x1p-20f; }

  // From column `column` of line `first` on.
  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t first, uint32_t column, Place at, float radius, Visitor&& visit) const {
    const float rounding = roundingOf(at.x, radius);
    const Scale scale = grid.totals->parts;
    const Span span{partOf(scale, grid.parts, at.x - radius - rounding),
                    partOf(scale, grid.parts, at.x + radius + rounding)};
    if constexpr (kFlat<CellT>) {
      return visitSlab(0, first, column, span, at, radius, visit);
    } else {
      uint32_t tested = 0, slab = larger(firstSlabAt(at.z, radius), first / grid.rows);
      for (; slab < grid.slabs && !(grid.slab[slab].reach.low - at.z > radius); ++slab) {
        tested += visitSlab(slab, first, column, span, at, radius, visit);
      }
      return tested;
    }
  }

  template <class Visitor>
  GW_MEMBER uint32_t visitSlab(uint32_t slab, uint32_t first, uint32_t column, Span span, Place at, float radius,
                               Visitor&& visit) const {
    const uint32_t end = (slab + 1) * grid.rows;
    uint32_t tested = 0, line = larger(slab * grid.rows + firstRowAt(slab, at.y, radius), first);
    for (; line < end && !(grid.reach[line].low - at.y > radius); ++line) {
      const Interval y = grid.height[line];
      if ((y.low - at.y > radius) | (at.y - y.high > radius)) continue;
      if constexpr (!kFlat<CellT>) {
        const Interval z = grid.depth[line];
        if (z.low - at.z > radius || at.z - z.high > radius) continue;
      }
      tested += visitLine(line, line == first ? column : 0, span, at, radius, visit);
    }
    return tested;
  }

  // The columns of one line from `column` on that may be within the radius. A few more are tested where that makes
  // their number a multiple of four: no loop has to begin or end with less than compilers test at once.
  template <class Visitor>
  GW_MEMBER uint32_t visitLine(uint32_t line, uint32_t column, Span span, Place at, float radius,
                               Visitor&& visit) const {
    const uint16_t* firstColumn = grid.firstColumn + size_t(line) * (grid.parts + 1);
    const CellT* cells = grid.cells + line * grid.columns;
    const uint32_t living = firstColumn[grid.parts];
    uint32_t begin = firstColumn[span.from], last = firstColumn[span.to + 1];
    if (grid.sorted) {
      begin = beginOf(cells, begin, firstColumn[span.from + 1], at.x, radius);
      last = endOf(cells, firstColumn[span.to], last, at.x, radius);
    }
    begin = larger(begin, column);
    last = larger(last, begin);
    const uint32_t end = smaller(begin + ((last - begin + 3) & ~3u), larger(living, begin));
    for (uint32_t c = begin; c < end; ++c) {
      const Place away = placeOf(cells[c]) - at;
      if (isNeighbour(away, radius)) visit(cells[c], line * grid.columns + c, away);
    }
    return end - begin;
  }

  GW_MEMBER uint32_t firstRowAt(uint32_t slab, float y, float radius) const {
    const uint32_t parts = grid.rows * kPartsPerRow;
    return grid.firstRow[slab * parts + partOf(grid.slab[slab].rows, parts, y - radius - roundingOf(y, radius))];
  }
  GW_MEMBER uint32_t firstSlabAt(float z, float radius) const {
    const uint32_t parts = grid.slabs * kPartsPerRow;
    return grid.firstSlab[partOf(grid.totals->slabs, parts, z - radius - roundingOf(z, radius))];
  }

  // The index says in which columns a span of a sorted row begins or ends. Bisection makes them few, without branches
  // since its steps are equally likely to go either way.
  GW_MEMBER uint32_t beginOf(const CellT* cells, uint32_t begin, uint32_t end, float x, float radius) const {
    uint32_t count = end - begin;
    while (count > kFew) {
      const uint32_t half = count / 2;
      begin += cells[begin + half - 1].x - x < -radius ? half : 0;
      count -= half;
    }
    return begin;
  }

  GW_MEMBER uint32_t endOf(const CellT* cells, uint32_t begin, uint32_t end, float x, float radius) const {
    uint32_t count = end - begin;
    while (count > kFew) {
      const uint32_t half = count / 2;
      begin += cells[begin + half - 1].x - x > radius ? 0 : half;
      count -= half;
    }
    return begin + count;
  }

  static constexpr uint32_t kFew = 8;
};
// Of a view.
template <class CellT>
RowGather(NGridView<CellT>) -> RowGather<CellT>;

}  // namespace gw::GW_DEVICE
