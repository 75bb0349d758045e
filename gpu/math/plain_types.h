// Plain data shared by host and devices: no functions, so nothing here can be compiled twice.
#pragma once

#include <cstdint>

namespace gw {

// A place, an offset or a force in the plane.
struct alignas(8) Float2 {
  float x, y;  // along each axis
};

// The same in space.
struct Float3 {
  float x, y, z;  // along each axis
};

// Four numbers that a kernel reads at once.
struct alignas(16) Float4 {
  float x, y, z, w;  // in the order in memory
};

// Four words that a kernel reads at once.
struct alignas(16) Uint4 {
  uint32_t x, y, z, w;  // in the order in memory
};

// One cell of an NGrid: the entity's place, its id, and a type tag that the grid carries along but
// never reads. A dead cell sits at (+infinity, +infinity) and keeps its id.
struct alignas(16) Cell {
  float x, y;     // place, m
  uint32_t id;    // 0 .. cells - 1, each in exactly one cell
  uint32_t type;  // the caller's
};

// The same in three dimensions, without the tag.
struct alignas(16) Cell3 {
  float x, y, z;  // place, m
  uint32_t id;    // 0 .. cells - 1, each in exactly one cell
};

}  // namespace gw
