#include "tests/reference/ngrid_oracles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>

#include "tests/reference/ngrid_axes.h"

namespace gw::naive {
namespace {

using test::GridShape;
using test::Upkeep;

void stretch(Cell& cell) {
  cell.x *= test::kStretch;
  cell.y *= test::kStretch;
}
void stretch(Cell3& cell) {
  cell.x *= test::kStretch;
  cell.y *= test::kStretch;
  cell.z *= test::kStretch;
}

constexpr int kOrder[3][3] = {{0, 1, 2}, {1, 0, 2}, {2, 1, 0}};

template <class CellT>
bool before(const CellT& a, const CellT& b, int axis) {
  const auto key = [&](const CellT& c) {
    return std::tuple(along(c, kOrder[axis][0]), along(c, kOrder[axis][1]), along(c, kOrder[axis][2]), c.id);
  };
  return key(a) < key(b);
}

// The cell before this one on its line of an axis; -1 for the first.
int64_t predecessor(GridShape shape, uint32_t i, int axis) {
  const uint32_t slabCells = shape.columns * shape.rows;
  if (axis == 0) return i % shape.columns > 0 ? int64_t(i) - 1 : -1;
  if (axis == 1) return i % slabCells >= shape.columns ? int64_t(i) - shape.columns : -1;
  return i >= slabCells ? int64_t(i) - slabCells : -1;
}

// Every line of an axis, as the places of its cells.
std::vector<std::vector<uint32_t>> linesOf(GridShape shape, int axis) {
  std::vector<std::vector<uint32_t>> lines;
  std::vector<uint32_t> lineOf(shape.cells());
  for (uint32_t i = 0; i < shape.cells(); ++i) {
    const int64_t last = predecessor(shape, i, axis);
    if (last < 0) {
      lineOf[i] = uint32_t(lines.size());
      lines.emplace_back();
    } else {
      lineOf[i] = lineOf[size_t(last)];
    }
    lines[lineOf[i]].push_back(i);
  }
  return lines;
}

template <class CellT>
void sortLines(GridShape shape, std::vector<CellT>& cells, int axis) {
  for (const auto& places : linesOf(shape, axis)) {
    std::vector<CellT> line;
    for (uint32_t i : places) line.push_back(cells[i]);
    sortAlong(line, axis);
    for (size_t k = 0; k < places.size(); ++k) cells[places[k]] = line[k];
  }
}

template <class CellT>
std::vector<uint32_t> placesById(const std::vector<CellT>& cells) {
  std::vector<uint32_t> cellOf(cells.size());
  for (uint32_t i = 0; i < cells.size(); ++i) cellOf[cells[i].id] = i;
  return cellOf;
}

struct Extent {
  float low = kInfinite, high = -kInfinite;
  void take(float place) {
    low = std::min(low, place);
    high = std::max(high, place);
  }
};

template <class CellT>
Extent extentOf(const std::vector<CellT>& cells, int axis) {
  Extent extent;
  for (const CellT& cell : cells) {
    if (lives(cell)) extent.take(along(cell, axis));
  }
  return extent;
}

uint32_t scaled(float value, uint32_t count) {
  if (!(value > 0.0f)) return 0;
  return value < float(count - 1) ? uint32_t(value) : count - 1;
}

// The parts of x that rows are indexed by: of what the living spanned after the upkeep before.
struct Parts {
  uint32_t count;
  float low = 0.0f, perMetre = 0.0f;

  Parts(Extent x, uint32_t parts) : count(parts) {
    if (!(x.low < kInfinite)) return;
    low = x.low;
    const float width = x.high - x.low;
    if (width > 0.0f) perMetre = float(parts) / width;
  }
  uint32_t of(float x) const { return scaled((x - low) * perMetre, count); }
};

// Nothing is known yet.
constexpr Extent kUnknown{0.0f, 0.0f};

uint32_t partsOf(GridShape shape, bool packed) {
  if (packed) return shape.columns + shape.columns / 2;
  return std::max(std::min(12288 / shape.lines(), 2 * shape.columns), 1u);
}

bool keepsPacked(Upkeep upkeep) {
  return upkeep == Upkeep::refresh || upkeep == Upkeep::pack || upkeep == Upkeep::repack;
}

// Fills in what is known about the rows of state.cells, which are in order already.
template <class CellT>
void describe(GridShape shape, test::GridStateOf<CellT>& state, const Parts& parts) {
  for (uint32_t line = 0; line < shape.lines(); ++line) {
    const auto begin = state.cells.begin() + ptrdiff_t(line * shape.columns);
    const std::vector<CellT> row(begin, begin + shape.columns);
    const Extent y = extentOf(row, 1), z = extentOf(row, 2);
    state.low.push_back(y.low);
    state.high.push_back(y.high);
    if (!flat(CellT{})) {
      state.near.push_back(z.low);
      state.far.push_back(z.high);
    }
    state.living.push_back(uint32_t(std::count_if(row.begin(), row.end(), [](const CellT& c) { return lives(c); })));
    for (uint32_t p = 0; p <= parts.count; ++p) {
      state.starts.push_back(uint32_t(
          std::count_if(row.begin(), row.end(), [&](const CellT& c) { return lives(c) && parts.of(c.x) < p; })));
    }
  }
  for (uint32_t line = 0; line < shape.lines(); ++line) {
    const uint32_t first = line / shape.rows * shape.rows, end = first + shape.rows;
    state.reachHigh.push_back(*std::max_element(state.high.begin() + first, state.high.begin() + line + 1));
    state.reachLow.push_back(*std::min_element(state.low.begin() + line, state.low.begin() + end));
  }
  if (flat(CellT{})) return;
  for (uint32_t slab = 0; slab < shape.slabs; ++slab) {
    state.slabReachHigh.push_back(*std::max_element(state.far.begin(), state.far.begin() + (slab + 1) * shape.rows));
    state.slabReachLow.push_back(*std::min_element(state.near.begin() + slab * shape.rows, state.near.end()));
  }
}

// All by z, cut into slabs, each by y, cut into rows.
template <class CellT>
void packByOrder(GridShape shape, std::vector<CellT>& cells) {
  const auto keyed = [](const CellT& c) { return std::tuple(along(c, 1), c.x, c.id); };
  std::sort(cells.begin(), cells.end(), [&](const CellT& a, const CellT& b) {
    return std::tuple(along(a, 2), keyed(a)) < std::tuple(along(b, 2), keyed(b));
  });
  const ptrdiff_t slabCells = ptrdiff_t(shape.columns * shape.rows);
  for (ptrdiff_t begin = 0; begin < ptrdiff_t(cells.size()); begin += slabCells) {
    std::sort(cells.begin() + begin, cells.begin() + begin + slabCells,
              [&](const CellT& a, const CellT& b) { return keyed(a) < keyed(b); });
  }
}

// The same by levels, each level in the order it had.
template <class CellT>
void packByLevels(GridShape shape, std::vector<CellT>& cells, Extent y, Extent z) {
  const auto levelOf = [](float place, Extent all, uint32_t levels) {
    const float height = all.high - all.low;
    return height > 0.0f ? scaled((place - all.low) * (float(levels) / height), levels) : 0;
  };
  const auto arrange = [&](ptrdiff_t begin, ptrdiff_t end, int axis, Extent all, uint32_t levels) {
    std::stable_sort(cells.begin() + begin, cells.begin() + end, [&](const CellT& a, const CellT& b) {
      const uint32_t levelA = lives(a) ? levelOf(along(a, axis), all, levels) : levels;
      return levelA < (lives(b) ? levelOf(along(b, axis), all, levels) : levels);
    });
  };
  const ptrdiff_t slabCells = ptrdiff_t(shape.columns * shape.rows), n = ptrdiff_t(cells.size());
  if (!flat(CellT{})) arrange(0, n, 2, z, 32 * shape.slabs);
  for (ptrdiff_t begin = 0; begin < n; begin += slabCells) arrange(begin, begin + slabCells, 1, y, 32 * shape.rows);
}

// Each row into parts of x, each part in the order it had, the dead last.
template <class CellT>
void splitRows(GridShape shape, std::vector<CellT>& cells, const Parts& parts) {
  for (ptrdiff_t begin = 0; begin < ptrdiff_t(cells.size()); begin += shape.columns) {
    const auto first = cells.begin() + begin, end = first + shape.columns;
    std::stable_sort(first, end, [&](const CellT& a, const CellT& b) {
      return (lives(a) ? parts.of(a.x) : parts.count) < (lives(b) ? parts.of(b.x) : parts.count);
    });
  }
}

// One odd and one even pass along an axis.
template <class CellT>
void comparePairs(GridShape shape, std::vector<CellT>& cells, int axis) {
  for (size_t start : {1u, 0u}) {
    for (const auto& line : linesOf(shape, axis)) {
      for (size_t k = start; k + 1 < line.size(); k += 2) {
        if (before(cells[line[k + 1]], cells[line[k]], axis)) std::swap(cells[line[k]], cells[line[k + 1]]);
      }
    }
  }
}

template <class CellT>
void maintain(GridShape shape, std::vector<CellT>& cells) {
  for (int axis = 2; axis >= 0; --axis) sortLines(shape, cells, axis);
}

// What an upkeep makes of the cells; and, for what it says about them, as they were before its last step, and the
// extent that the rows were indexed by.
template <class CellT>
struct Arranged {
  std::vector<CellT> was;
  Extent x = kUnknown;
};

template <class CellT>
Arranged<CellT> arrange(GridShape shape, std::vector<CellT>& cells, Upkeep upkeep) {
  std::vector<CellT> was = cells;
  Extent x = kUnknown;
  switch (upkeep) {
    case Upkeep::maintain:
      maintain(shape, cells);
      break;
    case Upkeep::sortUntilStable:
      for (bool first = true; first || placesById(was) != placesById(cells); first = false) {
        was = cells;
        maintain(shape, cells);
        if (!first) x = extentOf(cells, 0);
      }
      break;
    case Upkeep::transpose:
      for (int axis = 2; axis >= 0; --axis) comparePairs(shape, cells, axis);
      break;
    case Upkeep::rebuild:  // indexes its rows twice, the second time by what the first has shown
      packByOrder(shape, cells);
      sortLines(shape, cells, 0);
      was = cells;
      x = extentOf(cells, 0);
      break;
    case Upkeep::refresh:
      splitRows(shape, cells, Parts(x, partsOf(shape, true)));
      break;
    case Upkeep::pack:
    case Upkeep::repack: {
      packByOrder(shape, cells);
      sortLines(shape, cells, 0);
      const Extent y = extentOf(cells, 1), z = extentOf(cells, 2);
      x = extentOf(cells, 0);
      const Parts parts(x, partsOf(shape, true));
      splitRows(shape, cells, parts);
      was = cells;
      if (upkeep == Upkeep::repack) {
        for (CellT& cell : cells) stretch(cell);
      }
      packByLevels(shape, cells, y, z);
      splitRows(shape, cells, parts);
      break;
    }
  }
  return {was, x};
}

}  // namespace

template <class CellT>
void sortAlong(std::vector<CellT>& line, int axis) {
  std::sort(line.begin(), line.end(), [&](const CellT& a, const CellT& b) { return before(a, b, axis); });
}

template <class CellT>
test::GridStateOf<CellT> upkeep(GridShape shape, std::vector<CellT> cells, Upkeep upkeep) {
  const Arranged<CellT> arranged = arrange(shape, cells, upkeep);
  const std::vector<uint32_t> was = placesById(arranged.was);
  test::GridStateOf<CellT> state;
  state.cells = cells;
  state.cellOf = placesById(cells);
  for (size_t id = 0; id < was.size(); ++id) state.moved += was[id] != state.cellOf[id];
  if (upkeep != Upkeep::transpose) describe(shape, state, Parts(arranged.x, partsOf(shape, keepsPacked(upkeep))));
  return state;
}

template <class CellT>
std::string difference(const test::GridStateOf<CellT>& expected, const test::GridStateOf<CellT>& actual) {
  for (size_t i = 0; i < expected.cells.size(); ++i) {
    const CellT &mine = expected.cells[i], &theirs = actual.cells[i];
    if (mine.id != theirs.id) {
      return "cell " + std::to_string(i) + " holds " + std::to_string(theirs.id) + " instead of " +
             std::to_string(mine.id);
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (along(mine, axis) != along(theirs, axis)) return "entity " + std::to_string(mine.id) + " has changed";
    }
    if constexpr (flat(CellT{})) {
      if (mine.type != theirs.type) return "entity " + std::to_string(mine.id) + " has changed its type";
    }
  }
  if (expected.cellOf != actual.cellOf) return "cellOf is not the inverse";
  if (expected.moved != actual.moved) {
    return std::to_string(actual.moved) + " moved instead of " + std::to_string(expected.moved);
  }
  if (expected.living != actual.living) return "the living are miscounted";
  if (expected.low != actual.low || expected.high != actual.high) return "an interval of y is wrong";
  if (expected.near != actual.near || expected.far != actual.far) return "an interval of z is wrong";
  if (expected.reachLow != actual.reachLow || expected.reachHigh != actual.reachHigh) return "a reach is wrong";
  if (expected.slabReachLow != actual.slabReachLow || expected.slabReachHigh != actual.slabReachHigh) {
    return "a slab's reach is wrong";
  }
  return expected.starts == actual.starts ? "" : "an index is wrong";
}

template <class CellT>
uint32_t misaligned(GridShape shape, const std::vector<CellT>& cells) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < cells.size(); ++i) {
    bool behind = false;
    for (int axis = 0; axis < 3; ++axis) {
      const int64_t last = predecessor(shape, i, axis);
      behind |= last >= 0 && lives(cells[i]) && before(cells[i], cells[size_t(last)], axis);
    }
    count += behind;
  }
  return count;
}

template <class CellT>
double meanStep(GridShape shape, const std::vector<CellT>& cells, int axis) {
  double sum = 0;
  uint32_t steps = 0;
  for (uint32_t i = 0; i < cells.size(); ++i) {
    const int64_t last = predecessor(shape, i, axis);
    if (last < 0 || !lives(cells[i]) || !lives(cells[size_t(last)])) continue;
    sum += std::fabs(double(along(cells[i], axis)) - double(along(cells[size_t(last)], axis)));
    ++steps;
  }
  return steps ? sum / steps : 0.0;
}

#define GW_INSTANTIATE(CellT)                                                                        \
  template void sortAlong(std::vector<CellT>&, int);                                                 \
  template test::GridStateOf<CellT> upkeep(GridShape, std::vector<CellT>, Upkeep);                   \
  template std::string difference(const test::GridStateOf<CellT>&, const test::GridStateOf<CellT>&); \
  template uint32_t misaligned(GridShape, const std::vector<CellT>&);                                \
  template double meanStep(GridShape, const std::vector<CellT>&, int);
GW_INSTANTIATE(Cell)
GW_INSTANTIATE(Cell3)
#undef GW_INSTANTIATE

}  // namespace gw::naive
