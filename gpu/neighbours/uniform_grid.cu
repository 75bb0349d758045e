#include <gpuwars/uniform_grid.h>

#include <cmath>
#include <stdexcept>

namespace gw::GW_DEVICE {
namespace {

// One item: one cell, kept aside while the others move.
template <class CellT>
struct BinOfCell {
  CellT* before;
  const CellT* cells;
  Bins bins;
  uint32_t dead;

  GW_BODY uint32_t operator()(uint32_t i) const {
    const CellT cell = before[i] = cells[i];
    if (!isLiving(cell.x)) return dead;
    const auto place = placeOf(cell);
    return (bins.along(2, heightOf(place)) * bins.count[1] + bins.along(1, place.y)) * bins.count[0] +
           bins.along(0, place.x);
  }
};

template <class CellT>
struct MoveCell {
  CellT* cells;
  uint32_t* cellOf;
  const CellT* before;

  GW_BODY void operator()(uint32_t from, uint32_t to) const {
    const CellT cell = before[from];
    cells[to] = cell;
    cellOf[cell.id] = to;
  }
};

}  // namespace

Bins binsOver(Float3 low, Float3 high, float size, uint32_t entities) {
  const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(from[axis]) || !std::isfinite(to[axis]) || from[axis] > to[axis]) {
      throw std::invalid_argument("A uniform grid's region goes from a finite low corner to a finite higher one.");
    }
  }
  if (!(size > 0.0f) || !std::isfinite(size)) {
    throw std::invalid_argument("The bins of a uniform grid have a finite size above 0 m.");
  }
  double wanted = size;
  const auto binsAlong = [&](int axis) { return std::floor((to[axis] - from[axis]) / wanted) + 1.0; };
  while (binsAlong(0) * binsAlong(1) * binsAlong(2) > 4.0 * entities + 64.0) wanted *= 1.125;
  Bins bins{};
  bins.perMetre = float(1.0 / wanted);
  for (int axis = 0; axis < 3; ++axis) {
    bins.low[axis] = float(from[axis]);
    bins.count[axis] = uint32_t(binsAlong(axis));
  }
  return bins;
}

Bins binsOver(Float2 low, Float2 high, float size, uint32_t entities) {
  return binsOver(Float3{low.x, low.y, 0.0f}, Float3{high.x, high.y, 0.0f}, size, entities);
}

template <class CellT>
UniformGrid<CellT>::UniformGrid(Queue& queue, uint32_t count, const Bins& bins)
    : bins_(bins), sort_(queue, count, bins.all() + 1), before_(queue, count) {}

template <class CellT>
void UniformGrid<CellT>::maintain(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  sort_.run(queue, BinOfCell<CellT>{before_.data(), d_cells, bins_, bins_.all()},
            MoveCell<CellT>{d_cells, d_cellOf, before_.data()});
}

template class UniformGrid<Cell>;
template class UniformGrid<Cell3>;

}  // namespace gw::GW_DEVICE
