#include "tests/reference/gpu_oracles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
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

}  // namespace gw::naive
