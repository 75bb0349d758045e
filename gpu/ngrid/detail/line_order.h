// The total orders that lines are sorted by: along their own axis, then by the other axes (thesis, rules 1 to 9), then
// by id. Both zeros are one place; the dead, at +infinity, come last. Not for users of the NGrid.
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/neighbour.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

template <class CellT>
GW_FN float xOf(const CellT& cell) {
  return cell.x;
}
template <class CellT>
GW_FN float yOf(const CellT& cell) {
  return cell.y;
}
template <class CellT>
GW_FN float zOf(const CellT& cell) {
  return heightOf(placeOf(cell));  // 0 in 2D
}

// The bits of a place as an integer of the same order; both zeros are one place.
GW_FN uint32_t placeBits(float place) {
  return orderedBits(place + 0.0f);
}

// x, y, z; y, x, z; z, y, x; then id. Places are not NaN.
struct ByX {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return xOf(cell);
  }
  // What decides between cells equal along the line: first this, then that.
  template <class CellT>
  GW_MEMBER float across(const CellT& cell, bool last) const {
    return last ? zOf(cell) : yOf(cell);
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    if (zOf(a) != zOf(b)) return zOf(a) < zOf(b);
    return a.id < b.id;
  }
};

struct ByY {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return yOf(cell);
  }
  template <class CellT>
  GW_MEMBER float across(const CellT& cell, bool last) const {
    return last ? zOf(cell) : xOf(cell);
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    if (zOf(a) != zOf(b)) return zOf(a) < zOf(b);
    return a.id < b.id;
  }
};

struct ByZ {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return zOf(cell);
  }
  template <class CellT>
  GW_MEMBER float across(const CellT& cell, bool last) const {
    return last ? xOf(cell) : yOf(cell);
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    if (zOf(a) != zOf(b)) return zOf(a) < zOf(b);
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    return a.id < b.id;
  }
};

}  // namespace gw::GW_DEVICE
