// What a neighbour is: one definition for every method, in rounded floats, so that all exact methods find
// the same set. Prune only by the same rounded differences: x_j - x < -r, never x_j < x - r.
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// The place of a cell.
GW_FN Float2 placeOf(const Cell& cell) {
  return {cell.x, cell.y};
}

// The place of a cell.
GW_FN Float3 placeOf(const Cell3& cell) {
  return {cell.x, cell.y, cell.z};
}

// What places of these cells are: Float2 or Float3.
template <class CellT>
using PlaceOf = decltype(placeOf(CellT{}));

// The offset from b to a, rounded once per axis.
GW_FN Float2 operator-(Float2 a, Float2 b) {
  return {a.x - b.x, a.y - b.y};
}
// The offset from b to a, rounded once per axis.
GW_FN Float3 operator-(Float3 a, Float3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// Whether these cells have two dimensions.
template <class CellT>
inline constexpr bool kFlat = sizeof(PlaceOf<CellT>) == sizeof(Float2);

// Two dimensions are three of one layer.
GW_FN float heightOf(Float2) {
  return 0.0f;
}
// The third coordinate.
GW_FN float heightOf(Float3 place) {
  return place.z;
}

// The definition: `away` is the rounded difference of two places, radius in [0, infinity].
GW_FN bool isNeighbour(Float2 away, float radius) {
  // The most selective test stands first; the other two matter only where squares are rounded.
  return away.x * away.x + away.y * away.y <= radius * radius && magnitude(away.x) <= radius &&
         magnitude(away.y) <= radius;
}
// The definition: `away` is the rounded difference of two places, radius in [0, infinity].
GW_FN bool isNeighbour(Float3 away, float radius) {
  // Without branches: compilers then test several cells at once, which they do of two dimensions as it is.
  const bool inX = magnitude(away.x) <= radius, inY = magnitude(away.y) <= radius, inZ = magnitude(away.z) <= radius;
  return (away.x * away.x + away.y * away.y + away.z * away.z <= radius * radius) & inX & inY & inZ;
}

// The same cell with another id, dead: it sits at +infinity.
GW_FN Cell deadCell(Cell cell, uint32_t id) {
  return {kInfinity, kInfinity, id, cell.type};
}
// The same in three dimensions.
GW_FN Cell3 deadCell(Cell3, uint32_t id) {
  return {kInfinity, kInfinity, kInfinity, id};
}
// Of a cell's x: the dead sit at +infinity.
GW_FN bool isLiving(float x) {
  return x < kInfinity;
}

}  // namespace gw::GW_DEVICE
