// Plain data shared by host and devices: no functions, so nothing here can be compiled twice.
#pragma once

#include <cstdint>

namespace gw {

struct alignas(8) Float2 {
  float x, y;
};

struct Float3 {
  float x, y, z;
};

struct alignas(16) Float4 {
  float x, y, z, w;
};

struct alignas(16) Uint4 {
  uint32_t x, y, z, w;
};

// One cell of an NGrid: the entity's place, its id, and a type tag that the grid carries along but
// never reads. A dead cell sits at (+infinity, +infinity) and keeps its id.
struct alignas(16) Cell {
  float x, y;
  uint32_t id;
  uint32_t type;
};

// The same in three dimensions, without the tag.
struct alignas(16) Cell3 {
  float x, y, z;
  uint32_t id;
};

}  // namespace gw
