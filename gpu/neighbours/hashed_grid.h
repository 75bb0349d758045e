// The uniform grid with index sort of the thesis (Joselli 2013, chapter 3, after Teschner et al. 2003): unbounded
// space is cut into square (in 3D cubic) bins, a bin's coordinates are hashed to one of as many buckets as there are
// entities, and an array of *indexes* is sorted by bucket; the cells themselves stay where they are. A search
// looks up the bucket of each bin it meets, one by one, and reaches each cell through its index.
//
// Exact: the same sets as brute force. Bins that share a bucket are told apart by the cell's own bin. It is here to be
// compared with; the grid of uniform_grid.h is better in every way but for space without bounds.
#pragma once

#include <gpuwars/bin_sort.h>
#include <gpuwars/neighbour.h>

namespace gw::GW_DEVICE {

// Coordinates of a bin: what is too far out for an int counts to the outermost.
GW_FN int32_t hashedBinAlong(float place, float perMetre) {
  constexpr float kOutermost = 1 << 30;
  const float scaled = place * perMetre;
  if (!(scaled > -kOutermost)) return int32_t(-kOutermost);  // NaN too
  if (scaled >= kOutermost) return int32_t(kOutermost);
  const int32_t towardsZero = int32_t(scaled);
  return towardsZero - (float(towardsZero) > scaled ? 1 : 0);
}

// The hash of a bin, as published.
GW_FN uint32_t bucketOf(int32_t x, int32_t y, int32_t z, uint32_t buckets) {
  return (uint32_t(x) * 92837111u ^ uint32_t(y) * 689287499u ^ uint32_t(z) * 283923481u) % buckets;
}

// What kernels see, and the search. Copy it into a kernel by value.
template <class CellT>
struct HashedGather {
  const CellT* cells;     // [count], in any order
  const uint32_t* index;  // [count] of cells, by bucket, the dead last
  const uint32_t* begin;  // [count + 2] of each bucket
  uint32_t count;         // of cells, and of buckets
  float perMetre;         // bins

  // As RowGather::operator(); O(bins met, up to all + their buckets).
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
  GW_MEMBER uint32_t after(uint32_t cell, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    return visitFrom(cell + 1, at, radius, visit);
  }

 private:
  struct Range {
    int32_t first, last;
    GW_MEMBER float length() const { return float(last) - float(first) + 1.0f; }
  };

  // As Bins::first() and last(): widened by more than the rounding of a neighbour's difference.
  GW_MEMBER Range rangeOf(float place, float radius) const {
    const float rounding = (magnitude(place) + radius) * 0x1p-20f;
    return {hashedBinAlong(place - radius - rounding, perMetre), hashedBinAlong(place + radius + rounding, perMetre)};
  }

  template <class Visitor>
  GW_MEMBER uint32_t visitFrom(uint32_t from, PlaceOf<CellT> at, float radius, Visitor&& visit) const {
    const Range x = rangeOf(at.x, radius), y = rangeOf(at.y, radius);
    const Range z = kFlat<CellT> ? Range{0, 0} : rangeOf(heightOf(at), radius);
    uint32_t tested = 0;
    const auto test = [&](uint32_t i) {
      const PlaceOf<CellT> away = placeOf(cells[i]) - at;
      ++tested;
      if (isNeighbour(away, radius)) visit(cells[i], i, away);
    };
    if (x.length() * y.length() * z.length() > float(count)) {  // more bins than entities
      for (uint32_t i = from; i < count; ++i) {
        if (isLiving(cells[i].x)) test(i);
      }
      return tested;
    }
    for (int32_t bz = z.first; bz <= z.last; ++bz) {
      for (int32_t by = y.first; by <= y.last; ++by) {
        for (int32_t bx = x.first; bx <= x.last; ++bx) {
          const uint32_t bucket = bucketOf(bx, by, bz, count);
          for (uint32_t k = begin[bucket]; k < begin[bucket + 1]; ++k) {
            const uint32_t i = index[k];
            if (i >= from && stands(cells[i], bx, by, bz)) test(i);
          }
        }
      }
    }
    return tested;
  }

  GW_MEMBER bool stands(const CellT& cell, int32_t bx, int32_t by, int32_t bz) const {
    const PlaceOf<CellT> place = placeOf(cell);
    return hashedBinAlong(place.x, perMetre) == bx && hashedBinAlong(place.y, perMetre) == by &&
           (kFlat<CellT> || hashedBinAlong(heightOf(place), perMetre) == bz);
  }
};

// Its queue outlives it; the cells are the caller's.
template <class CellT>
class HashedGrid {
 public:
  HashedGrid() = default;
  // binSize (m) above 0 and finite, else std::invalid_argument; best as large as the usual radius.
  HashedGrid(Queue& queue, uint32_t count, float binSize);

  // The search; valid until the next maintain().
  HashedGather<CellT> view(const CellT* d_cells) const {
    return {d_cells, index_.data(), sort_.begin(), uint32_t(index_.size()), perMetre_};
  }
  size_t bytes() const { return sort_.bytes() + index_.size() * sizeof(uint32_t); }  // beyond the cells

  // Upkeep after motion: rebuilds the indexes. O(count).
  void maintain(Queue& queue, const CellT* d_cells);

 private:
  BinSort sort_;
  Buffer<uint32_t> index_;
  float perMetre_ = 1.0f;
};

}  // namespace gw::GW_DEVICE
