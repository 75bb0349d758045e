// How many neighbours all points have together.
#include <gpuwars/ngrid.h>
#include <gpuwars/row_gather.h>

#include <numeric>

#include "../count.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one cell.
struct CountOthers {
  uint32_t* counts;
  RowGather<Cell> search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const Cell self = search.grid.cells[i];
    uint32_t others = 0;
    if (isLiving(self.x)) {
      search.around(i, placeOf(self), radius,
                    [&](const Cell& other, uint32_t, Float2) { others += other.id != self.id; });
    }
    counts[i] = others;
  }
};

}  // namespace

uint64_t countPairs(Queue& queue, const std::vector<Cell>& points, float radius) {
  const NDimensions dimensions = chooseDimensions(uint32_t(points.size()), {100.0f, 100.0f, 0.0f}, radius);
  NGrid<Cell> grid(queue, dimensions);
  Buffer<Cell> cells(queue, dimensions.cells());
  Buffer<uint32_t> cellOf(queue, dimensions.cells()), counts(queue, dimensions.cells());
  cells.upload(padded(points, dimensions));
  grid.rebuild(queue, cells.data(), cellOf.data());
  forEach(queue, Count{dimensions.cells()}, CountOthers{counts.data(), {grid.view(cells.data())}, radius});
  const std::vector<uint32_t> found = counts.download();
  return std::accumulate(found.begin(), found.end(), uint64_t{0});
}

uint64_t countPairs(const ExecOptions& options, const std::vector<Cell>& points, float radius) {
  Queue queue(options);
  return countPairs(queue, points, radius);
}

}  // namespace gw::GW_DEVICE
