#include "bench/neighbours/crowd.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>

namespace gw::bench {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr bool flat(const Cell&) {
  return true;
}
constexpr bool flat(const Cell3&) {
  return false;
}
void place(Cell& cell, const double* at, uint32_t id) {
  cell = {float(at[0]), float(at[1]), id, 0};
}
void place(Cell3& cell, const double* at, uint32_t id) {
  cell = {float(at[0]), float(at[1]), float(at[2]), id};
}
float* axisOf(Cell& cell, int axis) {
  return axis == 0 ? &cell.x : &cell.y;
}
float* axisOf(Cell3& cell, int axis) {
  return axis == 0 ? &cell.x : axis == 1 ? &cell.y : &cell.z;
}
double distance2(const Cell& a, const Cell& b) {
  return double(a.x - b.x) * (a.x - b.x) + double(a.y - b.y) * (a.y - b.y);
}
double distance2(const Cell3& a, const Cell3& b) {
  return double(a.x - b.x) * (a.x - b.x) + double(a.y - b.y) * (a.y - b.y) + double(a.z - b.z) * (a.z - b.z);
}

// The radius with so many others in it on average, from a sample of askers; and what it really comes to.
template <class CellT>
std::pair<float, double> fitRadius(const std::vector<CellT>& cells) {
  const size_t askers = std::min<size_t>(cells.size(), 400);
  const size_t rank = std::min<size_t>(size_t(kNeighbours * double(askers)), askers * (cells.size() - 1));
  std::vector<double> nearest;  // of all askers together, cut back to so many whenever there are a few times more
  double radius2 = HUGE_VAL;
  const auto cut = [&] {
    if (nearest.size() < rank) return;
    const auto last = nearest.begin() + std::ptrdiff_t(rank - 1);
    std::nth_element(nearest.begin(), last, nearest.end());
    radius2 = *last;
    nearest.erase(std::partition(last + 1, nearest.end(), [&](double d) { return d <= radius2; }), nearest.end());
  };
  for (size_t a = 0; a < askers; ++a) {
    const size_t asker = a * (cells.size() / askers);
    for (size_t i = 0; i < cells.size(); ++i) {
      const double d = distance2(cells[asker], cells[i]);
      if (i == asker || d > radius2) continue;
      nearest.push_back(d);
      if (nearest.size() > 4 * rank + cells.size() / 8) cut();
    }
  }
  cut();
  return {float(std::sqrt(radius2)) * 1.0001f, double(nearest.size()) / double(askers)};
}

}  // namespace

template <class CellT>
Crowd<CellT>::Crowd(uint32_t n, Distribution distribution, uint64_t seed) : byId(n), heading(n) {
  const int axes = flat(CellT{}) ? 2 : 3;
  // As wide for its height as the game's world, and as dense as the game's usual 0.4 per square metre.
  const double volume = double(n) / 0.4;
  const double side = axes == 2 ? std::sqrt(volume * 9.0 / 16.0) : std::cbrt(volume * 9.0 / 16.0);
  const double sizes[3] = {side * 16.0 / 9.0, side, axes == 3 ? side : 0.0};
  for (int axis = 0; axis < 3; ++axis) world[axis] = float(sizes[axis]);

  std::mt19937_64 random(seed);
  const auto unit = [&] { return (double(random() >> 11) + 0.5) * 0x1p-53; };
  const auto gaussian = [&] { return std::sqrt(-2.0 * std::log(unit())) * std::cos(2.0 * kPi * unit()); };
  double heaps[32][3];
  for (auto& heap : heaps) {
    for (int axis = 0; axis < 3; ++axis) heap[axis] = (0.1 + 0.8 * unit()) * sizes[axis];
  }
  const double middle[3] = {0.45 * sizes[0], 0.55 * sizes[1], 0.5 * sizes[2]};
  double at[3] = {};
  for (uint32_t id = 0; id < n; ++id) {
    const bool again = distribution == Distribution::pairs && id % 2 == 1;
    const bool swarming = distribution == Distribution::swarm && unit() < 0.7;
    const double* heap = heaps[random() % 32];
    for (int axis = 0; axis < axes && !again; ++axis) {
      do {
        if (distribution == Distribution::clusters) {
          at[axis] = heap[axis] + gaussian() * 0.03 * side;
        } else if (swarming) {
          at[axis] = middle[axis] + gaussian() * 0.08 * side;
        } else if (distribution == Distribution::line && axis > 0) {
          at[axis] = 0.5 * sizes[axis];
        } else {
          at[axis] = unit() * sizes[axis];
        }
      } while (at[axis] < 0.0 || at[axis] > sizes[axis]);
    }
    place(byId[id], at, id);
    const double turn = 2.0 * kPi * unit(), up = axes == 3 ? 2.0 * unit() - 1.0 : 0.0, level = std::sqrt(1.0 - up * up);
    heading[id] = {float(std::cos(turn) * level), float(std::sin(turn) * level), float(up)};
    if (distribution == Distribution::line) heading[id] = {turn < kPi ? 1.0f : -1.0f, 0.0f, 0.0f};
    if (again) heading[id] = heading[id - 1];
  }
  std::tie(radius, neighbours) = fitRadius(byId);
}

template <class CellT>
void Crowd<CellT>::step(float radii) {
  const int axes = flat(CellT{}) ? 2 : 3;
  for (size_t id = 0; id < byId.size(); ++id) {
    float* const ways[3] = {&heading[id].x, &heading[id].y, &heading[id].z};
    for (int axis = 0; axis < axes; ++axis) {
      float& at = *axisOf(byId[id], axis);
      at += *ways[axis] * radii * radius;
      if (at < 0.0f || at > world[axis]) {
        *ways[axis] = -*ways[axis];
        at = std::clamp(at < 0.0f ? -at : 2.0f * world[axis] - at, 0.0f, world[axis]);
      }
    }
  }
}

template struct Crowd<Cell>;
template struct Crowd<Cell3>;

}  // namespace gw::bench
