// Who is near whom: 1,000 points at random in a square, each of them asks for all others within 3 m.
// Prints a line per point: id, x, y, then the ids of its neighbours.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "gpu/philox.h"
#include "gpu/row_gather.h"

using namespace gw;       // plain data
using namespace gw::cpu;  // what runs on the device

constexpr uint32_t kPoints = 1000, kMost = 32;  // neighbours that are kept of each
constexpr float kSide_m = 100.0f, kRadius_m = 3.0f;

// A kernel is a struct: what it needs as members, and what to do for item i. Here an item is one cell of the grid.
struct FindNeighbours {
  uint32_t *ids, *counts;  // outputs, by id: [][kMost], []
  RowGather<Cell> search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell self = search.grid.cells[i];
    if (!isLiving(self.x)) return;  // a cell that only fills the last row
    uint32_t count = 0;
    search.around(i, placeOf(self), kRadius_m, [&](const Cell& other, uint32_t, Float2) {
      if (other.id == self.id) return;
      if (count < kMost) ids[self.id * kMost + count] = other.id;
      ++count;
    });
    counts[self.id] = count;
  }
};

int main() {
  std::vector<Cell> points(kPoints);
  for (uint32_t i = 0; i < kPoints; ++i) {
    const Uint4 random = philox(7, {i, 0, 0, 0});
    points[i] = {unitFloat(random.x) * kSide_m, unitFloat(random.y) * kSide_m, i, 0};
  }

  Queue queue(ExecOptions{});  // takes every processor
  const NDimensions dimensions = chooseDimensions(kPoints, {kSide_m, kSide_m, 0.0f}, kRadius_m);
  NGrid<Cell> grid(queue, dimensions);
  Buffer<Cell> cells(queue, dimensions.cells());       // the positions are the grid...
  Buffer<uint32_t> cellOf(queue, dimensions.cells());  // ...and this says which cell each id stands in
  cells.upload(padded(points, dimensions));
  grid.rebuild(queue, cells.data(), cellOf.data());

  Buffer<uint32_t> ids(queue, kPoints * kMost), counts(queue, kPoints);
  forEach(queue, Count{dimensions.cells()}, FindNeighbours{ids.data(), counts.data(), {grid.view(cells.data())}});

  std::vector<uint32_t> found = ids.download();
  const std::vector<uint32_t> counted = counts.download();
  for (uint32_t i = 0; i < kPoints; ++i) {
    uint32_t* mine = &found[i * kMost];
    const uint32_t kept = std::min(counted[i], kMost);
    std::sort(mine, mine + kept);  // they come in the order of the cells
    std::printf("%u %.9g %.9g:", i, double(points[i].x), double(points[i].y));
    for (uint32_t n = 0; n < kept; ++n) std::printf(" %u", mine[n]);
    std::printf("\n");
  }
  return 0;
}
