// The oracle: tests every cell. Same interface and same set as row_gather.h; it walks backwards, so that a
// result that depends on the order of visits shows at once.
#pragma once

#include "gpu/neighbour.h"
#include "gpu/plain_types.h"

namespace gw::GW_DEVICE {

struct BruteForce {
  const Cell* cells;
  uint32_t count;

  // As RowGather::operator(); O(count) per query. Dead cells are passed over and not counted.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(float x, float y, float radius, Visitor&& visit) const {
    return visitFrom(0, x, y, radius, visit);
  }

  // As RowGather::around().
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t, float x, float y, float radius, Visitor&& visit) const {
    return visitFrom(0, x, y, radius, visit);
  }

  // As RowGather::after().
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, float x, float y, float radius, Visitor&& visit) const {
    return visitFrom(index + 1, x, y, radius, visit);
  }

 private:
  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t begin, float x, float y, float radius, Visitor&& visit) const {
    uint32_t tested = 0;
    for (uint32_t i = count; i-- > begin;) {
      if (!isLiving(cells[i].x)) continue;
      const float dx = cells[i].x - x, dy = cells[i].y - y;
      ++tested;
      if (isNeighbour(dx, dy, radius)) visit(cells[i], i, dx, dy);
    }
    return tested;
  }
};

}  // namespace gw::GW_DEVICE
