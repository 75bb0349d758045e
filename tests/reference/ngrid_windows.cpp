// The thesis' two windows around a cell, fixed and adaptive.
#include <algorithm>
#include <cmath>

#include "tests/reference/gpu_oracles.h"
#include "tests/reference/ngrid_axes.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::naive {
namespace {

using test::GridShape;

void insertIfNear(std::vector<uint32_t>& ids, const Cell& cell, const Cell& centre, float radius) {
  if (!neighbours({cell}, test::Query{centre.x, centre.y, radius}).empty()) ids.push_back(cell.id);
}
void insertIfNear(std::vector<uint32_t>& ids, const Cell3& cell, const Cell3& centre, float radius) {
  if (!neighbours({cell}, test::Query3{centre.x, centre.y, centre.z, radius}).empty()) ids.push_back(cell.id);
}

struct Place {
  uint32_t along[3];
};
Place placeOf(GridShape shape, uint32_t cell) {
  const uint32_t line = cell / shape.columns;
  return {{cell % shape.columns, line % shape.rows, line / shape.rows}};
}

template <class CellT>
std::vector<uint32_t> nearIn(GridShape shape, const std::vector<CellT>& arranged, uint32_t cell, const uint32_t* first,
                             const uint32_t* last, float radius) {
  std::vector<uint32_t> ids;
  for (uint32_t s = first[2]; s <= last[2]; ++s) {
    for (uint32_t r = first[1]; r <= last[1]; ++r) {
      for (uint32_t c = first[0]; c <= last[0]; ++c) {
        insertIfNear(ids, arranged[(s * shape.rows + r) * shape.columns + c], arranged[cell], radius);
      }
    }
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

template <class CellT>
std::vector<uint32_t> windowNeighbours(GridShape shape, const std::vector<CellT>& arranged, uint32_t cell,
                                       const uint32_t (&away)[3], float radius) {
  const uint32_t cells[3] = {shape.columns, shape.rows, shape.slabs};
  const Place at = placeOf(shape, cell);
  uint32_t first[3], last[3];
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = at.along[axis] - std::min(at.along[axis], away[axis]);
    last[axis] = at.along[axis] + std::min(cells[axis] - 1 - at.along[axis], away[axis]);
  }
  return nearIn(shape, arranged, cell, first, last, radius);
}

template <class CellT>
std::vector<uint32_t> adaptiveNeighbours(GridShape shape, const std::vector<CellT>& arranged, uint32_t cell,
                                         float radius) {
  const uint32_t cells[3] = {shape.columns, shape.rows, shape.slabs},
                 stride[3] = {1, shape.columns, shape.columns * shape.rows};
  const Place at = placeOf(shape, cell);
  uint32_t first[3], last[3];
  for (int axis = 0; axis < 3; ++axis) {
    const auto close = [&](uint32_t k) {
      const CellT& other = arranged[cell - at.along[axis] * stride[axis] + k * stride[axis]];
      return std::fabs(along(other, axis) - along(arranged[cell], axis)) <= radius;
    };
    first[axis] = last[axis] = at.along[axis];
    while (first[axis] > 0 && close(first[axis] - 1)) --first[axis];
    while (last[axis] + 1 < cells[axis] && close(last[axis] + 1)) ++last[axis];
  }
  return nearIn(shape, arranged, cell, first, last, radius);
}

#define GW_INSTANTIATE(CellT)                                                                     \
  template std::vector<uint32_t> windowNeighbours(GridShape, const std::vector<CellT>&, uint32_t, \
                                                  const uint32_t(&)[3], float);                   \
  template std::vector<uint32_t> adaptiveNeighbours(GridShape, const std::vector<CellT>&, uint32_t, float);
GW_INSTANTIATE(Cell)
GW_INSTANTIATE(Cell3)
#undef GW_INSTANTIATE

}  // namespace gw::naive
