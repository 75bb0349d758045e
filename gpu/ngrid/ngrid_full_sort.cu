// The full sort, the packing of sort-tile-recursive R-trees (Leutenegger et al. 1997): all by y, cut into rows. In 3D
// all by z, cut into slabs, and each slab by y.
//
// Stable sorts from the least axis to the greatest, the first from the order of ids, make the order total: by y, x and
// id; in 3D by z, y, x and id, and within a slab by y, x and id.
#include <gpuwars/ngrid.h>
#include <gpuwars/sort_keys.h>

#include "detail/line_order.h"
#include "detail/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

enum class Axis : uint32_t { x, y, z };

template <class CellT>
GW_FN uint32_t bitsAlong(const CellT& cell, Axis axis) {
  return placeBits(axis == Axis::x ? xOf(cell) : axis == Axis::y ? yOf(cell) : zOf(cell));
}

// One item: one cell. A key is what to sort by, above the cell; the keys stand in the order of ids.
template <class CellT>
struct FirstKeys {
  uint64_t* keys;
  const CellT* cells;
  Axis axis;
  GW_BODY void operator()(uint32_t i) const { keys[cells[i].id] = uint64_t(bitsAlong(cells[i], axis)) << 32 | i; }
};

// One item: one key, which is to sort by another axis now.
template <class CellT>
struct NextKeys {
  uint64_t* keys;
  const CellT* cells;
  Axis axis;
  GW_BODY void operator()(uint32_t k) const {
    const uint32_t cell = uint32_t(keys[k]);
    keys[k] = uint64_t(bitsAlong(cells[cell], axis)) << 32 | cell;
  }
};

// One item: one place in the order by z, which says which slab its cell comes to.
struct CutIntoSlabs {
  uint32_t* slabOf;  // [cells]
  const uint64_t* keys;
  uint32_t slabCells;
  GW_BODY void operator()(uint32_t k) const { slabOf[uint32_t(keys[k])] = k / slabCells; }
};

struct KeepOrder {
  uint32_t* order;
  const uint64_t* keys;
  GW_BODY void operator()(uint32_t k) const { order[k] = uint32_t(keys[k]); }
};

struct SlabKeys {
  uint64_t* keys;
  const uint32_t *order, *slabOf;
  GW_BODY void operator()(uint32_t k) const { keys[k] = uint64_t(slabOf[order[k]]) << 32 | order[k]; }
};

template <class CellT>
struct TakeByKeys {
  CellT* out;
  const CellT* in;
  const uint64_t* keys;
  GW_BODY void operator()(uint32_t k) const { out[k] = in[uint32_t(keys[k])]; }
};

}  // namespace

template <class CellT>
void NGrid<CellT>::rebuild(Queue& queue, CellT* d_cells, uint32_t* d_cellOf) {
  requireBuffers(d_cells, d_cellOf);
  const uint32_t n = dimensions_.cells();
  const Count all{n};
  SortKeys sort(queue, n);
  const auto sortBy = [&](Axis axis) {
    forEach(queue, all, NextKeys<CellT>{sort.keys(), d_cells, axis});
    sort.run(queue, 32);
  };
  forEach(queue, all, FirstKeys<CellT>{sort.keys(), d_cells, Axis::x});
  sort.run(queue, 32);
  sortBy(Axis::y);
  if (dimensions_.slabs > 1) {
    Buffer<uint32_t> order(queue, n), slabOf(queue, n);
    forEach(queue, all, KeepOrder{order.data(), sort.keys()});
    sortBy(Axis::z);
    forEach(queue, all, CutIntoSlabs{slabOf.data(), sort.keys(), dimensions_.columns * dimensions_.rows});
    forEach(queue, all, SlabKeys{sort.keys(), order.data(), slabOf.data()});
    sort.run(queue, 32, 32 + bitsBelow(dimensions_.slabs));
    queue.synchronise();  // before what it reads goes
  }
  Buffer<CellT> before(queue, n);
  copyBytes(queue, before.data(), d_cells, n * sizeof(CellT), Copy::onDevice);
  forEach(queue, all, TakeByKeys<CellT>{d_cells, before.data(), sort.keys()});
  sortRows(queue, d_cells, d_cellOf, nullptr, true);
  // Once more, since rows are indexed by the parts of x that were known before.
  if (kept_ == Kept::packed) {
    splitRows(queue, d_cells, d_cells, d_cellOf, true);
  } else {
    sortRows(queue, d_cells, d_cellOf, nullptr, true);
  }
  queue.synchronise();
  rounds_ = 1;
}

template void NGrid<Cell>::rebuild(Queue&, Cell*, uint32_t*);
template void NGrid<Cell3>::rebuild(Queue&, Cell3*, uint32_t*);

}  // namespace gw::GW_DEVICE
