// How many cells an NGrid has along each axis (thesis, property 5: they multiply to the number of cells, n). Entities
// that do not fill a product are padded by dead cells at +infinity, which sort behind all others.
#pragma once

#include <gpuwars/exec.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// The longest row, column or pole. A block of 1,024 lanes holds so many cells in its registers, four a lane
// (block_lines.h): with eight, kernels spill. The cpu device keeps to it too, so that both can hold the same grids.
inline constexpr uint32_t kLongestLine = 4096;

// The longest that is chosen while lines of this length can hold all cells: beyond, a block is as large as blocks get,
// so few run at a time. The dimensions of recorded games depend on it.
inline constexpr uint32_t kLongLine = 2048;

// The cells along each axis.
struct NDimensions {
  uint32_t columns = 0, rows = 0, slabs = 1;  // along x, y, z; in 2D one slab

  // Rows of all slabs.
  uint32_t lines() const { return rows * slabs; }
  // Their product.
  uint32_t cells() const { return columns * rows * slabs; }
  // The same along every axis.
  bool operator==(const NDimensions&) const = default;
};

// All of these throw std::invalid_argument, and say which argument and the limit, when n is 0 or more cells than lines
// of kLongestLine (by chooseDimensions(), rows of 4,080) can hold, or a length is not as described. The box may be that
// of the data, with no length along some axes, or along any: all at one x, on a line, in one place. A z of 0 makes it
// 2D.

// For exact gathers of `radius` (m, finite, above 0) among n entities spread over a box of `size` (m, finite, at least
// 0): the rows and slabs for which a cost model expects the fastest search. What a search pays is mostly the two ends
// of its span in each row that it meets, and then the tests: cost = kRowCost * rows met + tests. So rows are fewer and
// longer than columns; docs/results/ngrid-performance.md has the fit.
NDimensions chooseDimensions(uint32_t n, Float3 size, float radius);

// For windowed gathers: so that n entities spread over the box stand as far apart along each axis, as far as
// the length of lines allows.
NDimensions chooseWindowDimensions(uint32_t n, Float3 size);

// The mean distance along each axis between neighbours on a line of that axis, both living; 0 along an axis with
// none. What the thesis balances.
struct Steps {
  float along[3];  // m, of x, y, z
  // Whether the largest differs from the smallest, of those axes that have neighbours, by more than `share` of it.
  bool differBy(float share) const;
};

// The thesis's own way to find them: start equal along all axes, sort, measure the steps, and change the dimensions
// until no step differs from another by more than a fifth. NGrid::steps() measures a grid in use; when they
// differ again, dimensions are to be found again.
inline constexpr float kStepsMayDiffer = 0.2f;

// The next ones to try for n entities: lines grow along the axis whose steps are long. The same ones when nothing
// better is near.
NDimensions balancedDimensions(uint32_t n, NDimensions now, const Steps& steps);

// Sorts what it is given (n cells in any order, all living places finite; n at least 1) as often as it takes,
// at most 16 times, in memory of its own. CellT is Cell or Cell3. Waits for the queue.
template <class CellT>
NDimensions findDimensions(Queue& queue, const CellT* h_cells, uint32_t n);

}  // namespace gw::GW_DEVICE
