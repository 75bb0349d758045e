// NGrid, 2D: the neighbourhood structure of Joselli's thesis (2013). n entities stand in n cells, and the
// array of their positions *is* the grid.
//
//      column 0   1   2   3          Every row is in ascending x, and every column nearly in ascending y:
//   row 2   [.4] [.5] [.6] [.7]      an entity's neighbours in the world stand near it in the grid.
//   row 1   [.2] [.1] [.3] [.9]      Dead cells sit at +infinity, so sorting groups them at the end of
//   row 0   [.0] [.8] [.a] [.b]      the rows and in the last rows.
//
// Properties (thesis, chapter 4):
//   1 as many cells as entities               2 one entity per cell
//   3 a cell takes its entity's size          4 and its place
//   5 the N-dimensions multiply to n          6 each line is ordered along its axis
//   7 one N-radius per axis                   8 the N-radius is fixed or adaptive
// 6 holds for rows after every maintain(); columns are misaligned by what the row pass moved. 7 and 8
// speak of windowed gathering (window_gather.h); the exact gather of row_gather.h needs no N-radius.
//
// Ties are broken by the other axis, then by id, so the order of a line is unique on every device.
#pragma once

#include "gpu/bits.h"
#include "gpu/buffer.h"
#include "gpu/plain_types.h"
#include "gpu/sort_keys.h"

namespace gw::GW_DEVICE {

// The longest row or column: a line is sorted in a block's shared memory (32 KiB of cells).
inline constexpr uint32_t kLongestLine = 2048;

// See NGrid::rowsWidened().
inline constexpr float kWorthRebuilding = 1.3f;

struct NDimensions {
  uint32_t columns = 0, rows = 0;
  uint32_t cells() const { return columns * rows; }
};

// Dimensions for at least n cells in whole rows, the row about 24 times as long as the column: what an exact
// gather pays is the two ends of its span in each row met, so fewer, longer rows are faster although they
// test more candidates. Full sort and gather of 65,536 by that ratio, over the uniform grid's in the same run:
// 6: 2.3, 12: 1.6, 24: 1.6, 48: 1.3, 96: 1.5 (swarm: 1.8, 1.5, 1.5, 1.5, 1.3). Throws
// std::invalid_argument when n does not fit kLongestLine squared.
NDimensions chooseDimensions(uint32_t n);

// The same for windowed gathers: columns to rows as `aspect`, the world's width to its height, so that n
// entities spread over the world stand as far apart along a row as along a column. aspect in (0, infinity).
NDimensions chooseWindowDimensions(uint32_t n, float aspect);

// What kernels see. Copy it into a kernel by value.
struct NGridView {
  const Cell* cells;  // [rows * columns], row by row
  uint32_t columns, rows;
  // Per row, of its living entities: the interval of y (+infinity, -infinity when none) and their number.
  const float *low, *high;
  const uint32_t* living;
  // The highest `high` of this and earlier rows, the lowest `low` of this and later rows: both ascend, so
  // the rows that can meet an interval are found by bisection.
  const float *reachHigh, *reachLow;
  // Per row, an index of x: the span from its first to its last living entity is cut into `buckets` equal parts, and
  // starts[row][b] is the first column in part b or later, starts[row][buckets] the number of the living.
  const uint16_t* starts;
  const float *left, *perMetre;  // where the first part begins (m), parts per metre
  uint32_t buckets;
  const float* heights;  // of all rows together, in metres: now, after the last rebuild

  // The part that x falls into: monotonic in x, and 0 for NaN.
  GW_MEMBER uint32_t bucketOf(uint32_t row, float x) const {
    const float bucket = (x - left[row]) * perMetre[row];
    if (!(bucket > 0.0f)) return 0;
    return bucket < float(buckets) ? uint32_t(bucket) : buckets - 1;
  }

  // See NGrid::rowsWidened().
  GW_MEMBER float widened() const {
    return heights[1] > 0.0f ? heights[0] / heights[1] : heights[0] > 0.0f ? kInfinity : 0.0f;
  }
};

class NGrid {
 public:
  NGrid() = default;
  NGrid(Queue& queue, NDimensions dimensions);

  NDimensions dimensions() const { return dimensions_; }
  NGridView view(const Cell* d_cells) const;
  size_t bytes() const;  // of device memory beyond the cells

  // Upkeep after motion: sorts each column by y, then each row by x, and refreshes the rows' intervals.
  // d_cellOf[id] becomes the cell of that id (ids are 0 .. cells - 1, each in exactly one cell). One pass
  // per axis: O(n log^2 n) bitonic on cuda; on cpu insertion, O(n) for the small motion of one tick.
  // Nothing is done while the word at d_hold (if any) is not 0: a captured tick cannot leave a launch out.
  void maintain(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold = nullptr);

  // Upkeep with frozen rows: who stands in which row stays as it is, each row is sorted by x, and the rows' intervals
  // are refreshed. Exact gathers stay exact and slow down while the rows widen: rebuild() when rowsWidened() says so.
  // O(n) on cpu for the small motion of one tick.
  void refresh(Queue& queue, Cell* d_cells, uint32_t* d_cellOf);

  // The summed heights of the rows by what they were after the last rebuild(); infinite when they had none then, 0 when
  // they have none now. A rebuild pays above about kWorthRebuilding. Waits for the queue.
  float rowsWidened() const;

  // Upkeep by partial odd-even transposition: one odd and one even pass along each axis, O(n). An entity moves
  // by at most two cells per axis, so one that is far from its place takes many calls to reach it; repeated
  // calls without motion end with every line in order. Rows are not in order after one call and their
  // intervals are not refreshed: for windowed gathers only.
  void transpose(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold = nullptr);

  // maintain() until hardly anything moves: the start that windowed gathers need. The full sort below leads
  // to another stable state, in which a window misses half of the neighbours.
  void settle(Queue& queue, Cell* d_cells, uint32_t* d_cellOf);

  // The full sort: all cells by y, cut into rows, each row by x (the packing of sort-tile-recursive
  // R-trees). For a start from an arbitrary arrangement; O(n log n).
  void rebuild(Queue& queue, Cell* d_cells, uint32_t* d_cellOf);

 private:
  void sortRows(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold, bool rebuilt);

  NDimensions dimensions_;
  Buffer<float> low_, high_, reachHigh_, reachLow_, left_, perMetre_;
  Buffer<uint32_t> living_;
  Buffer<uint16_t> starts_;
  uint32_t buckets_ = 0;
  SortKeys byY_;
  Buffer<Cell> scratch_;
  Buffer<float> heights_;  // of all rows together: now, after the last rebuild
};

}  // namespace gw::GW_DEVICE
