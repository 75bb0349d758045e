#include <gpuwars/bits.h>
#include <gpuwars/neighbour.h>
#include <gpuwars/ngrid.h>
#include <gpuwars/ngrid_dimensions.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace gw::GW_DEVICE {
namespace {

// Fitted: meeting one more row costs a search as much as this many more tests (docs/results/ngrid-performance.md).
constexpr double kRowCost = 25.0;

double smallerOf(double a, double b) {
  return b < a ? b : a;
}

// The library's may differ between machines, and dimensions that windows go by are part of a game. Newton's steps come
// from above, so they end when they no longer fall.
double cubeRoot(double volume) {
  const auto step = [&](double root) { return (2.0 * root + volume / (root * root)) / 3.0; };
  double root = volume > 1.0 ? volume : 1.0;
  for (double next = step(root); next < root; next = step(root)) root = next;
  return root;
}

uint32_t divideUp(uint32_t n, uint32_t by) {
  return n / by + (n % by ? 1 : 0);
}

// Returns how many axes the box has.
int checkedAxes(uint32_t n, Float3 size) {
  if (n == 0) throw std::invalid_argument("An NGrid of 0 cells was asked for; n is at least 1.");
  for (const float length : {size.x, size.y, size.z}) {
    if (!(length >= 0.0f && std::isfinite(length))) {
      throw std::invalid_argument(
          "The box of an NGrid has a finite size of at least 0 m along each axis (0 along z: in 2D).");
    }
  }
  return size.z > 0.0f ? 3 : 2;
}

[[noreturn]] void refuse(uint32_t n, uint64_t most) {
  throw std::invalid_argument("An NGrid of " + std::to_string(n) + " cells is too large: at most " +
                              std::to_string(most) + " fit; use fewer entities.");
}

// What a search of `radius` is expected to cost in this box, in tests. Along an axis without a length all are met.
double expectedCost(NDimensions d, Float3 size, float radius) {
  const auto met = [&](float along, uint32_t lines) {
    return along > 0.0f ? smallerOf(2.0 * double(radius) * lines / double(along) + 1.0, double(lines)) : double(lines);
  };
  const double rows = met(size.y, d.rows) * (size.z > 0.0f ? met(size.z, d.slabs) : 1.0);
  const double span = size.x > 0.0f ? smallerOf(2.0 * double(radius) / double(size.x), 1.0) : 1.0;
  return rows * (kRowCost + span * d.columns);
}

// How far apart n entities stand that are spread evenly along those axes of the box that have a length.
double distanceApart(uint32_t n, double x, double y, double z) {
  const bool inX = x > 0.0, inY = y > 0.0;  // z is above 0
  if (inX && inY) return cubeRoot(x * y * z / double(n));
  return inX ? std::sqrt(x * z / double(n)) : inY ? std::sqrt(y * z / double(n)) : z / double(n);
}

}  // namespace

bool Steps::differBy(float share) const {
  float least = kInfinity, most = 0.0f;
  for (float step : along) {
    if (step <= 0.0f) continue;
    least = smaller(least, step);
    most = larger(most, step);
  }
  return most - least > share * most;
}

NDimensions chooseDimensions(uint32_t n, Float3 size, float radius) {
  const int axes = checkedAxes(n, size);
  if (!(radius > 0.0f && std::isfinite(radius))) {
    throw std::invalid_argument("A radius to choose dimensions for is finite and above 0 m.");
  }
  const auto mostCells = [&](uint64_t longest) { return axes == 3 ? (1ull << 31) - 1 : (longest - 16) * longest; };
  if (n > mostCells(kLongestLine)) refuse(n, mostCells(kLongestLine));
  const uint32_t longest = n <= mostCells(kLongLine) ? kLongLine : kLongestLine;
  const uint32_t mostSlabs = axes == 3 ? smaller(longest, n) : 1;
  const auto forEachChoice = [&](const auto& look) {
    for (uint32_t slabs = 1; slabs <= mostSlabs; slabs += 1 + slabs / 16) {
      // Odd multiples of 16 cells: a stride that is a power of two would put a whole column into one cache set.
      for (uint32_t columns = 16; columns <= longest - 16; columns += 32) {
        const NDimensions d{columns, divideUp(divideUp(n, slabs), columns), slabs};
        if (d.rows <= longest && uint64_t(columns) * d.rows * slabs < 1ull << 31) {
          look(d, expectedCost(d, size, radius));
        }
      }
    }
  };
  double least = HUGE_VAL;
  forEachChoice([&](NDimensions, double cost) { least = smallerOf(least, cost); });
  // Of all that are about as good, the one with the least padding.
  NDimensions best{};
  forEachChoice([&](NDimensions d, double cost) {
    if (cost <= 1.03 * least && (best.columns == 0 || d.cells() < best.cells())) best = d;
  });
  if (best.columns == 0) refuse(n, mostCells(kLongestLine));
  return best;
}

NDimensions chooseWindowDimensions(uint32_t n, Float3 size) {
  const int axes = checkedAxes(n, size);
  const double x = size.x, y = size.y, z = size.z;
  const uint64_t most = axes == 3 ? (1ull << 31) - 1 : uint64_t(kLongestLine) * kLongestLine;
  if (n > most) refuse(n, most);
  const uint32_t longest = axes == 3 || n <= kLongLine * kLongLine ? kLongLine : kLongestLine;
  const auto fitting = [&](double wanted, uint32_t rest) {  // so many along an axis, and no fewer than the rest demands
    const uint32_t count = wanted < 1.0 ? 1 : wanted > longest ? longest : uint32_t(wanted);
    return larger(count, rest);
  };
  if (axes == 2) {
    const double wanted = y > 0.0 ? std::sqrt(double(n) * (x / y)) : double(n);  // without a height: one row
    const uint32_t columns = fitting(wanted + 0.5, divideUp(n, longest));
    return {columns, divideUp(n, columns)};
  }
  const double apart = distanceApart(n, x, y, z);
  const uint32_t columns = fitting(x / apart + 0.5, divideUp(n, longest * longest));
  const uint32_t rows = fitting(y / apart + 0.5, divideUp(divideUp(n, columns), longest));
  const NDimensions found{columns, rows, divideUp(divideUp(n, columns), rows)};
  if (uint64_t(found.columns) * found.rows * found.slabs >= 1ull << 31) refuse(n, (1ull << 31) - 1);
  return found;
}

NDimensions balancedDimensions(uint32_t n, NDimensions now, const Steps& steps) {
  const uint32_t cells[3] = {now.columns, now.rows, now.slabs};
  float size[3];
  float longest = 0.0f;
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = steps.along[axis] * float(int32_t(cells[axis]));
    longest = larger(longest, size[axis]);
  }
  if (!(longest > 0.0f)) return now;  // all in one place, or one alone
  const bool flat = now.slabs == 1 && steps.along[2] == 0.0f;
  // An axis along which nothing differs is as good as a very short one.
  for (float& length : size) length = larger(length, longest * 1e-6f);
  return chooseWindowDimensions(n, {size[0], size[1], flat ? 0.0f : size[2]});
}

template <class CellT>
NDimensions findDimensions(Queue& queue, const CellT* h_cells, uint32_t n) {
  if (!h_cells) throw std::invalid_argument("h_cells is null; give the entities to find dimensions for.");
  NDimensions now = chooseWindowDimensions(n, {1.0f, 1.0f, kFlat<CellT> ? 0.0f : 1.0f}), best = now;
  const std::vector<CellT> entities(h_cells, h_cells + n);
  float least = kInfinity;
  constexpr uint32_t kTries = 16;
  for (uint32_t tried = 0; tried < kTries; ++tried) {
    NGrid<CellT> grid(queue, now);
    Buffer<CellT> cells(queue, now.cells());
    Buffer<uint32_t> cellOf(queue, now.cells());
    cells.upload(padded(entities, now));
    grid.sortUntilStable(queue, cells.data(), cellOf.data());
    const Steps steps = grid.steps(queue, cells.data());
    float shortest = kInfinity, longest = 0.0f;
    for (float step : steps.along) {
      if (step > 0.0f) shortest = smaller(shortest, step);
      longest = larger(longest, step);
    }
    if (longest / shortest < least) {
      least = longest / shortest;
      best = now;
    }
    const NDimensions next = balancedDimensions(n, now, steps);
    if (!steps.differBy(kStepsMayDiffer) || next == now) break;
    now = next;
  }
  return best;
}

template NDimensions findDimensions(Queue&, const Cell*, uint32_t);
template NDimensions findDimensions(Queue&, const Cell3*, uint32_t);

}  // namespace gw::GW_DEVICE
