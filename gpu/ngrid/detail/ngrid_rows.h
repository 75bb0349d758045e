// What upkeep finds out about rows: shared by the kernels that leave rows in order. Not for users of the NGrid.
#pragma once

#include <gpuwars/neighbour.h>
#include <gpuwars/ngrid.h>

namespace gw::GW_DEVICE {

// Levels of y that packing tells apart, for each row (of z, for each slab): enough that rows overlap little.
inline constexpr uint32_t kLevelsPerLine = 32;

// What is written about rows, per line; and by what parts of x their index goes.
struct RowsFound {
  Interval *width, *height, *depth;  // x, y, z of the living; depth is null in 2D
  uint32_t *living, *moved;
  uint16_t* firstColumn;
  uint32_t parts;
  const GridTotals* before;  // as the last upkeep left them
};

GW_FN Scale scaleOf(Interval all, uint32_t parts) {
  const float width = all.high - all.low;
  if (!(all.low < kInfinity)) return {0.0f, 0.0f};  // no live entity
  return {all.low, width > 0.0f ? float(int32_t(parts)) / width : 0.0f};
}

GW_FN Interval joined(Interval a, Interval b) {
  return {smaller(a.low, b.low), larger(a.high, b.high)};
}

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
  template <class CellT>
  GW_BODY void take(const CellT& cell) {
    const bool lives = isLiving(cell.x);
    grow(x, cell.x, lives);
    grow(y, cell.y, lives);
    if constexpr (!kFlat<CellT>) grow(z, cell.z, lives);
    living += lives;
  }
  GW_BODY void join(const LivingBox& other) {
    x = joined(x, other.x);
    y = joined(y, other.y);
    z = joined(z, other.z);
    living += other.living;
    moved += other.moved;
  }
};

GW_BODY inline void writeRow(const RowsFound& found, uint32_t line, const LivingBox& box) {
  // Which of two zeros is the lower one depends on who came first: + 0.0f makes both +0.
  const auto settled = [](Interval along) { return Interval{along.low + 0.0f, along.high + 0.0f}; };
  found.width[line] = settled(box.x);
  found.height[line] = settled(box.y);
  if (found.depth) found.depth[line] = settled(box.z);
  found.living[line] = box.living;
  found.moved[line] = box.moved;
}

// Throw std::invalid_argument when one is null.
void requireCells(const void* d_cells);
void requireBuffers(const void* d_cells, const void* d_cellOf);

}  // namespace gw::GW_DEVICE
