#include "tests/naive/gpu_oracles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace gw::naive {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

bool near(float dx, float dy, float radius) {
  // Each product is rounded on its own: the variables keep compilers from being clever.
  const volatile float xx = dx * dx, yy = dy * dy, rr = radius * radius;
  return std::fabs(dx) <= radius && std::fabs(dy) <= radius && xx + yy <= rr;
}

// -0 before +0, as the keys of the full sort have it.
auto totalOrder(float value) {
  const int32_t bits = std::bit_cast<int32_t>(value);
  return bits < 0 ? int64_t(-1) - (int64_t(bits) & 0x7fffffff) : int64_t(bits);
}

// Fills in what is known about the rows of state.cells, which are sorted already.
void describeRows(test::GridShape shape, test::GridState& state) {
  state.cellOf.assign(shape.cells(), 0);
  for (uint32_t i = 0; i < shape.cells(); ++i) state.cellOf[state.cells[i].id] = i;
  for (uint32_t row = 0; row < shape.rows; ++row) {
    float low = kInfinite, high = -kInfinite;
    uint32_t living = 0;
    for (uint32_t c = 0; c < shape.columns; ++c) {
      const Cell& cell = state.cells[row * shape.columns + c];
      if (isDead(cell)) continue;
      low = std::min(low, cell.y);
      high = std::max(high, cell.y);
      ++living;
    }
    state.low.push_back(low);
    state.high.push_back(high);
    state.living.push_back(living);
  }
  for (uint32_t row = 0; row < shape.rows; ++row) {
    state.reachHigh.push_back(*std::max_element(state.high.begin(), state.high.begin() + row + 1));
    state.reachLow.push_back(*std::min_element(state.low.begin() + row, state.low.end()));
  }
}

void insertIfNear(std::vector<uint32_t>& ids, const Cell& cell, const Cell& centre, float radius) {
  if (!isDead(cell) && near(cell.x - centre.x, cell.y - centre.y, radius)) ids.push_back(cell.id);
}

}  // namespace

test::Words scan(const test::Words& in) {
  test::Words out;
  uint64_t sum = 0;
  for (uint64_t word : in) {
    out.push_back(sum);
    sum += word;
  }
  out.push_back(sum);
  return out;
}

test::Words foldLines(test::Words lines) {
  constexpr size_t kLanes = 128;
  for (size_t team = 0; team < lines.size() / kLanes; ++team) {
    test::Words line(lines.begin() + ptrdiff_t(team * kLanes), lines.begin() + ptrdiff_t((team + 1) * kLanes));
    std::reverse(line.begin(), line.end());
    for (size_t step = 1; step < kLanes; step *= 2) {
      test::Words next;
      for (size_t lane = 0; lane < kLanes; ++lane) next.push_back(3 * line[lane] + line[(lane + step) % kLanes]);
      line = next;
    }
    for (size_t lane = 0; lane < kLanes; ++lane) lines[team * kLanes + lane] = line[lane] + team;
  }
  return lines;
}

bool isDead(const Cell& cell) {
  return cell.x == kInfinite;
}

void sortByX(std::vector<Cell>& line) {
  std::sort(line.begin(), line.end(),
            [](const Cell& a, const Cell& b) { return std::tie(a.x, a.y, a.id) < std::tie(b.x, b.y, b.id); });
}

void sortByY(std::vector<Cell>& line) {
  std::sort(line.begin(), line.end(),
            [](const Cell& a, const Cell& b) { return std::tie(a.y, a.x, a.id) < std::tie(b.y, b.x, b.id); });
}

test::GridState upkeep(test::GridShape shape, std::vector<Cell> cells, test::Upkeep upkeep) {
  if (upkeep == test::Upkeep::rebuild) {
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Cell& a, const Cell& b) { return totalOrder(a.y) < totalOrder(b.y); });
  } else if (upkeep != test::Upkeep::refresh) {
    for (uint32_t column = 0; column < shape.columns; ++column) {
      std::vector<Cell> line;
      for (uint32_t row = 0; row < shape.rows; ++row) line.push_back(cells[row * shape.columns + column]);
      sortByY(line);
      for (uint32_t row = 0; row < shape.rows; ++row) cells[row * shape.columns + column] = line[row];
    }
  }
  test::GridState state;
  for (uint32_t row = 0; row < shape.rows; ++row) {
    const auto begin = cells.begin() + ptrdiff_t(row * shape.columns);
    std::vector<Cell> line(begin, begin + shape.columns);
    sortByX(line);
    state.cells.insert(state.cells.end(), line.begin(), line.end());
  }
  describeRows(shape, state);
  return state;
}

std::vector<Cell> transpose(test::GridShape shape, std::vector<Cell> cells) {
  const auto at = [&](uint32_t row, uint32_t column) -> Cell& { return cells[row * shape.columns + column]; };
  for (uint32_t start : {1u, 0u}) {
    for (uint32_t column = 0; column < shape.columns; ++column) {
      for (uint32_t row = start; row + 1 < shape.rows; row += 2) {
        std::vector<Cell> pair{at(row, column), at(row + 1, column)};
        sortByY(pair);
        at(row, column) = pair[0];
        at(row + 1, column) = pair[1];
      }
    }
  }
  for (uint32_t start : {1u, 0u}) {
    for (uint32_t row = 0; row < shape.rows; ++row) {
      for (uint32_t column = start; column + 1 < shape.columns; column += 2) {
        std::vector<Cell> pair{at(row, column), at(row, column + 1)};
        sortByX(pair);
        at(row, column) = pair[0];
        at(row, column + 1) = pair[1];
      }
    }
  }
  return cells;
}

std::vector<uint32_t> neighbours(const std::vector<Cell>& cells, test::Query query) {
  std::vector<uint32_t> ids;
  for (const Cell& cell : cells) insertIfNear(ids, cell, {query.x, query.y, 0, 0}, query.radius);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<uint32_t> neighbours(const std::vector<Cell3>& cells, test::Query3 query) {
  std::vector<uint32_t> ids;
  for (const Cell3& cell : cells) {
    if (cell.x == kInfinite) continue;
    const float dx = cell.x - query.x, dy = cell.y - query.y, dz = cell.z - query.z;
    if (std::fabs(dx) > query.radius || std::fabs(dy) > query.radius || std::fabs(dz) > query.radius) continue;
    if (dx * dx + dy * dy + dz * dz <= query.radius * query.radius) ids.push_back(cell.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

namespace {

// Items by bin, each bin a list of its own; `bins` holds one more for the dead.
template <class BinOf>
std::pair<std::vector<uint32_t>, std::vector<uint32_t>> listByBin(uint32_t items, uint32_t bins, const BinOf& binOf) {
  std::vector<std::vector<uint32_t>> lists(bins);
  for (uint32_t i = 0; i < items; ++i) lists.at(binOf(i)).push_back(i);
  std::vector<uint32_t> order, begin;
  for (const auto& list : lists) {
    begin.push_back(uint32_t(order.size()));
    order.insert(order.end(), list.begin(), list.end());
  }
  begin.push_back(items);
  return {order, begin};
}

}  // namespace

test::Binned binCells(const std::vector<Cell>& cells) {
  const uint32_t n = uint32_t(cells.size());
  double size = test::binSizeFor(n);
  const auto side = [&] { return uint32_t(double(test::kRegion) / size) + 1; };
  while (double(side()) * side() > 4.0 * n + 64) size *= 1.125;
  const uint32_t columns = side();
  const auto along = [&](float place) {
    const float scaled = place * float(1.0 / size);
    return scaled <= 0.0f ? 0u : scaled >= float(columns) ? columns - 1 : uint32_t(scaled);
  };
  test::Binned result;
  const auto [order, begin] = listByBin(n, columns * columns + 1, [&](uint32_t i) {
    return isDead(cells[i]) ? columns * columns : along(cells[i].y) * columns + along(cells[i].x);
  });
  result.begin = begin;
  result.cellOf.resize(n);
  for (uint32_t from : order) {
    result.cellOf[cells[from].id] = uint32_t(result.cells.size());
    result.cells.push_back(cells[from]);
  }
  return result;
}

test::Binned hashCells(const std::vector<Cell>& cells) {
  const uint32_t n = uint32_t(cells.size());
  const auto along = [&](float place) {
    const double scaled = std::floor(double(place * (1.0f / test::binSizeFor(n))));
    return uint64_t(int64_t(std::clamp(scaled, -1073741824.0, 1073741824.0)));
  };
  const auto [order, begin] = listByBin(n, n + 1, [&](uint32_t i) {
    if (isDead(cells[i])) return n;
    return uint32_t((along(cells[i].x) * 92837111 ^ along(cells[i].y) * 689287499) & 0xFFFFFFFFu) % n;
  });
  return {cells, order, begin};
}

std::vector<uint32_t> windowNeighbours(test::GridShape shape, const std::vector<Cell>& arranged, uint32_t cell,
                                       uint32_t columns, uint32_t rows, float radius) {
  const uint32_t column = cell % shape.columns, row = cell / shape.columns;
  const uint32_t lastRow = std::min(row + rows, shape.rows - 1),
                 lastColumn = std::min(column + columns, shape.columns - 1);
  std::vector<uint32_t> ids;
  for (uint32_t r = row - std::min(row, rows); r <= lastRow; ++r) {
    for (uint32_t c = column - std::min(column, columns); c <= lastColumn; ++c) {
      insertIfNear(ids, arranged[r * shape.columns + c], arranged[cell], radius);
    }
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<uint32_t> adaptiveNeighbours(test::GridShape shape, const std::vector<Cell>& arranged, uint32_t cell,
                                         float radius) {
  const Cell centre = arranged[cell];
  const uint32_t column = cell % shape.columns, row = cell / shape.columns;
  const auto alongX = [&](uint32_t c) { return std::fabs(arranged[row * shape.columns + c].x - centre.x) <= radius; };
  const auto alongY = [&](uint32_t r) {
    return std::fabs(arranged[r * shape.columns + column].y - centre.y) <= radius;
  };
  uint32_t left = column, right = column, down = row, up = row;
  while (left > 0 && alongX(left - 1)) --left;
  while (right + 1 < shape.columns && alongX(right + 1)) ++right;
  while (down > 0 && alongY(down - 1)) --down;
  while (up + 1 < shape.rows && alongY(up + 1)) ++up;
  std::vector<uint32_t> ids;
  for (uint32_t r = down; r <= up; ++r) {
    for (uint32_t c = left; c <= right; ++c) insertIfNear(ids, arranged[r * shape.columns + c], centre, radius);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace gw::naive
