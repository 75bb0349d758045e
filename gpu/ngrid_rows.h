// What upkeep finds out about rows: shared by the kernels that leave rows in order. Not for users of the NGrid.
#pragma once

#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {

inline constexpr uint32_t kLineLanes = GW_ON_CUDA ? 256 : 1;  // on cpu one lane walks along its line

// Levels of y that packing tells apart, for each row (of z, for each slab): enough that rows overlap little.
inline constexpr uint32_t kLevelsPerLine = 32;

// What is written about rows, per line.
struct RowsFound {
  GridRow* line;
  Interval* depth;  // null in 2D
  uint32_t *living, *moved;
  uint16_t* starts;
  uint32_t parts;
};

// The box around the living that a lane, or a team, has seen, and how many.
struct LivingBox {
  Interval x, y, z;
  uint32_t living, moved;

  GW_BODY static LivingBox nothing() {
    constexpr float kMost = __builtin_inff();
    return {{kMost, -kMost}, {kMost, -kMost}, {kMost, -kMost}, 0, 0};
  }
  GW_BODY static void grow(Interval& along, float place, bool lives) {
    along.low = smaller(along.low, lives ? place : kInfinity);
    along.high = larger(along.high, lives ? place : -kInfinity);
  }
  GW_BODY void join(const LivingBox& other) {
    x = {smaller(x.low, other.x.low), larger(x.high, other.x.high)};
    y = {smaller(y.low, other.y.low), larger(y.high, other.y.high)};
    z = {smaller(z.low, other.z.low), larger(z.high, other.z.high)};
    living += other.living;
    moved += other.moved;
  }

  // Which of two zeros is the lower one depends on who came first: + 0.0f makes both +0.
  GW_BODY static Interval settled(Interval along) { return {along.low + 0.0f, along.high + 0.0f}; }

  GW_BODY GridRow row(uint32_t parts) const {
    const float left = living ? x.low + 0.0f : 0.0f, width = living ? x.high - left : 0.0f;
    const Interval height = settled(y);
    return {height.low, height.high, left, width > 0.0f ? float(int32_t(parts)) / width : 0.0f};
  }
};

// Joins the boxes of all lanes into the first.
template <uint32_t kLanes, class Team>
GW_BODY void joinBoxes(const Team& team, LivingBox* boxes) {
  for (uint32_t half = kLanes / 2; half > 0; half /= 2) {
    team.phase([&](uint32_t lane) {
      if (lane < half) boxes[lane].join(boxes[lane + half]);
    });
  }
}

GW_BODY inline void writeRow(const RowsFound& found, uint32_t line, const LivingBox& box) {
  found.line[line] = box.row(found.parts);
  if (found.depth) found.depth[line] = LivingBox::settled(box.z);
  found.living[line] = box.living;
  found.moved[line] = box.moved;
}

// Throws std::invalid_argument when one is null.
void requireBuffers(const void* d_cells, const void* d_cellOf);

}  // namespace gw::GW_DEVICE
