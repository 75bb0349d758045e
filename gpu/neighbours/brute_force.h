// The oracle: tests every cell. Same interface and same set as row_gather.h; it walks backwards, so that a
// result that depends on the order of visits shows at once.
#pragma once

#include <gpuwars/neighbour.h>
#include <gpuwars/plain_types.h>

#include <type_traits>

namespace gw::GW_DEVICE {

// What kernels see, and the search. Copy it into a kernel by value.
template <class CellT>
struct BruteForce {
  const CellT* cells;  // [count], in any order
  uint32_t count;      // of cells, the dead included

  // As RowGather::operator(); O(count) per query. Dead cells are passed over and not counted.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(0, at, radius, visit);
  }

  // As RowGather::around().
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(0, at, radius, visit);
  }

  // As RowGather::after().
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(index + 1, at, radius, visit);
  }

 private:
  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t begin, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    uint32_t tested = 0;
    for (uint32_t i = count; i-- > begin;) {
      if (!isLiving(cells[i].x)) continue;
      ++tested;
      const PlaceOf<CellT> away = placeOf(cells[i]) - at;
      if (isNeighbour(away, radius)) visit(cells[i], i, away);
    }
    return tested;
  }
};
// Of cells that may be const.
template <class CellT>
BruteForce(CellT*, uint32_t) -> BruteForce<std::remove_const_t<CellT>>;

}  // namespace gw::GW_DEVICE
