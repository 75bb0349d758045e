// The best uniform grid we can write: the baseline that the NGrid is measured against. Space is cut into square (in
// 3D cubic) bins, the array of cells is kept in the order of the bins, row by row, so that a search reads one
// contiguous run of it per row of bins it meets.
//
//   bins      0  1  2  3        a search around bin 5, radius one bin:
//             4  5  6  7            runs [begin[0], begin[3]), [begin[4], begin[7]), [begin[8], begin[11])
//             8  9 10 11
//
// Exact: finds precisely what brute force finds. The bin of a place is a monotonic function of it even when
// rounded, and a search widens its edges by more than their rounding; isNeighbour() decides. Places outside
// the region count to the bins at its edges. The dead stand in a bin of their own, after all others.
//
// The sort is stable, so the arrangement is unique on every device.
#pragma once

#include <gpuwars/bin_sort.h>
#include <gpuwars/neighbour.h>

namespace gw::GW_DEVICE {

// How space is cut. A region may be a point or have no height: then there is one bin along that axis.
struct Bins {
  float low[3];       // m
  float perMetre;     // bins
  uint32_t count[3];  // along x, y, z
  // Of all axes.
  uint32_t all() const { return count[0] * count[1] * count[2]; }

  // The bin of a place along an axis.
  GW_MEMBER uint32_t along(uint32_t axis, float place) const {
    const float bin = (place - low[axis]) * perMetre;
    if (!(bin > 0.0f)) return 0;  // NaN too
    return bin < float(count[axis]) ? uint32_t(bin) : count[axis] - 1;
  }
  // The bins that may hold what is within radius of place. The rounded difference of a neighbour is at most the
  // radius, its place then at most place + radius and the rounding of both: far less than what is added here.
  GW_MEMBER uint32_t first(uint32_t axis, float place, float radius) const {
    return along(axis, place - radius - roundingOf(place, radius));
  }
  // As first().
  GW_MEMBER uint32_t last(uint32_t axis, float place, float radius) const {
    return along(axis, place + radius + roundingOf(place, radius));
  }

 private:
  GW_MEMBER static float roundingOf(float place, float radius) { return (magnitude(place) + radius) * 0x1p-20f; }
};

// Bins of at least `size` (m) over the box from low to high, larger where there would be more than four times as many
// as entities. Throws std::invalid_argument when a number is not finite, size is not positive or low is above high.
Bins binsOver(Float2 low, Float2 high, float size, uint32_t entities);
// The same in three dimensions.
Bins binsOver(Float3 low, Float3 high, float size, uint32_t entities);

// What kernels see, and the search. Copy it into a kernel by value.
template <class CellT>
struct GridGather {
  const CellT* cells;     // [count], by bins, the dead last
  const uint32_t* begin;  // [bins + 2] of each bin
  Bins bins;              // how space was cut

  // As RowGather::operator(); O(bins met) + the runs.
  template <class Visitor>
  GW_MEMBER uint32_t operator()(PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(0, at, radius, visit);
  }

  // As RowGather::around().
  template <class Visitor>
  GW_MEMBER uint32_t around(uint32_t, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(0, at, radius, visit);
  }

  // As RowGather::after().
  template <class Visitor>
  GW_MEMBER uint32_t after(uint32_t index, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(index + 1, at, radius, visit);
  }

 private:
  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t from, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    const uint32_t left = bins.first(0, at.x, radius), right = bins.last(0, at.x, radius);
    const uint32_t low = bins.first(1, at.y, radius), high = bins.last(1, at.y, radius);
    const uint32_t bottom = kFlat<CellT> ? 0 : bins.first(2, heightOf(at), radius);
    const uint32_t top = kFlat<CellT> ? 0 : bins.last(2, heightOf(at), radius);
    uint32_t tested = 0;
    for (uint32_t z = bottom; z <= top; ++z) {
      for (uint32_t y = low; y <= high; ++y) {
        const uint32_t row = (z * bins.count[1] + y) * bins.count[0];
        const uint32_t first = larger(from, begin[row + left]), last = larger(begin[row + right + 1], first);
        // Up to three more where the row has them: no loop has to end with less than compilers test at once.
        const uint32_t end = smaller(first + ((last - first + 3) & ~3u), larger(begin[row + bins.count[0]], first));
        for (uint32_t i = first; i < end; ++i) {
          const PlaceOf<CellT> away = placeOf(cells[i]) - at;
          if (isNeighbour(away, radius)) visit(cells[i], i, away);
        }
        tested += end > first ? end - first : 0;
      }
    }
    return tested;
  }
};

// Its queue outlives it; the cells are the caller's.
template <class CellT>
class UniformGrid {
 public:
  UniformGrid() = default;
  // For count cells, 1 to 2^31. Throws as Buffer does.
  UniformGrid(Queue& queue, uint32_t count, const Bins& bins);

  // The search; valid until the next maintain().
  GridGather<CellT> view(const CellT* d_cells) const { return {d_cells, sort_.begin(), bins_}; }
  size_t bytes() const { return sort_.bytes() + before_.size() * sizeof(CellT); }  // beyond the cells

  // Upkeep after motion: brings the cells into the order of their bins. d_cellOf[id] becomes the cell of that id
  // (ids are 0 .. count - 1, each in exactly one cell). O(count + bins).
  void maintain(Queue& queue, CellT* d_cells, uint32_t* d_cellOf);

 private:
  Bins bins_{};
  BinSort sort_;
  Buffer<CellT> before_;
};

}  // namespace gw::GW_DEVICE
