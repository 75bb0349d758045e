// What the reference versions of the NGrid share: the axes of a cell.
#pragma once

#include <cstdint>
#include <limits>

#include "tests/gpu/probes.h"

namespace gw::naive {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

inline float along(const Cell& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : 0.0f;
}
inline float along(const Cell3& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}
constexpr bool flat(const Cell&) {
  return true;
}
constexpr bool flat(const Cell3&) {
  return false;
}
inline bool lives(const Cell& cell) {
  return cell.x < kInfinite;
}
inline bool lives(const Cell3& cell) {
  return cell.x < kInfinite;
}

}  // namespace gw::naive
