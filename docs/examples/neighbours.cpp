// Neighbours of points: 1,000 points at random in a square, each of them asks for all others within 3 m.
// Prints a line per point: id, x, y, then the ids of its neighbours.
#include <gpuwars/neighbour_lists.h>
#include <gpuwars/philox.h>
#include <gpuwars/row_gather.h>

#include <cstdio>
#include <vector>

using namespace gw;       // plain data
using namespace gw::cpu;  // what runs on the device

constexpr uint32_t kPoints = 1000, kRoom = 20000;  // neighbours of all together
constexpr float kSide_m = 100.0f, kRadius_m = 3.0f;

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

  NeighbourLists lists(queue, dimensions.cells(), kRoom);
  lists.build(queue, RowGather{grid.view(cells.data())}, cells.data(), kRadius_m);

  const std::vector<uint32_t> begin = lists.downloadBegin(), neighbours = lists.downloadNeighbours();
  for (uint32_t i = 0; i < kPoints; ++i) {
    std::printf("%u %.9g %.9g:", i, double(points[i].x), double(points[i].y));
    for (uint32_t n = begin[i]; n < begin[i + 1]; ++n) std::printf(" %u", neighbours[n]);
    std::printf("\n");
  }
  return 0;
}
