// Every way of gpu/ to find neighbours, all with one face: how many cells it wants, construction, upkeep, search,
// misaligned cells, memory. What kernels search by; included by the benches' own kernel files.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bench/neighbours/contender.h"
#include "gpu/neighbours/brute_force.h"
#include "gpu/neighbours/hashed_grid.h"
#include "gpu/neighbours/uniform_grid.h"
#include "gpu/ngrid/ngrid.h"
#include "gpu/ngrid/row_gather.h"
#include "gpu/ngrid/window_gather.h"

namespace gw::GW_DEVICE::ways {

using bench::Place;
using bench::Way;

// Those without lines have none out of order.
struct NoLines {
  template <class CellT>
  static std::optional<uint32_t> misaligned(Queue&, const CellT*) {
    return {};
  }
};

template <class CellT>
struct Brute : NoLines {
  uint32_t count = 0;
  uint32_t prepare(Queue&, const Place&, uint32_t n) { return count = n; }
  void build(Queue&, CellT*, uint32_t*) {}
  void maintain(Queue&, CellT*, uint32_t*) {}
  BruteForce<CellT> search(const CellT* cells) const { return {cells, count}; }
  size_t bytes() const { return 0; }
};

template <class CellT>
struct Bin : NoLines {
  explicit Bin(int perRadius) : perRadius(perRadius) {}
  int perRadius;  // bins along a radius
  UniformGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    const float size = place.radius / float(perRadius);
    if constexpr (kFlat<CellT>) {
      grid = {queue, n, binsOver(Float2{0, 0}, Float2{place.world[0], place.world[1]}, size, n)};
    } else {
      grid = {queue, n, binsOver(Float3{0, 0, 0}, Float3{place.world[0], place.world[1], place.world[2]}, size, n)};
    }
    return n;
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.maintain(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.maintain(queue, cells, cellOf); }
  GridGather<CellT> search(const CellT* cells) const { return grid.view(cells); }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT>
struct Hash : NoLines {
  HashedGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    grid = {queue, n, place.radius};
    return n;
  }
  void build(Queue& queue, CellT* cells, uint32_t*) { grid.maintain(queue, cells); }
  void maintain(Queue& queue, CellT* cells, uint32_t*) { grid.maintain(queue, cells); }
  HashedGather<CellT> search(const CellT* cells) const { return grid.view(cells); }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT>
Float3 sizeOf(const Place& place) {
  return {place.world[0], place.world[1], kFlat<CellT> ? 0.0f : place.world[2]};
}

// What all NGrids have.
template <class CellT>
struct Lines {
  NGrid<CellT> grid{};
  std::optional<uint32_t> misaligned(Queue& queue, const CellT* cells) {
    return grid.upkeepReport(queue, cells).misaligned;
  }
  size_t bytes() const { return grid.bytes(); }
};

enum class Upkeep { bitonic, full, packed, frozen };

template <class CellT>
struct Rows : Lines<CellT> {
  explicit Rows(Upkeep upkeep) : upkeep(upkeep) {}
  using Lines<CellT>::grid;
  Upkeep upkeep;
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    const bool inPlace = upkeep == Upkeep::bitonic || upkeep == Upkeep::full;
    grid = {queue, chooseDimensions(n, sizeOf<CellT>(place), place.radius), inPlace ? Kept::inPlace : Kept::packed};
    return grid.dimensions().cells();
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.rebuild(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) {
    switch (upkeep) {
      case Upkeep::bitonic:
        return grid.maintain(queue, cells, cellOf);
      case Upkeep::full:
        return grid.rebuild(queue, cells, cellOf);
      case Upkeep::packed:
        return grid.pack(queue, cells, cellOf);
      case Upkeep::frozen:
        return grid.rowsWidened() > kWorthRebuilding ? grid.pack(queue, cells, cellOf)
                                                     : grid.refresh(queue, cells, cellOf);
    }
  }
  RowGather<CellT> search(const CellT* cells) const { return {grid.view(cells)}; }
};

template <class CellT, template <class> class Gather>
struct Windows : Lines<CellT> {
  explicit Windows(bool oddEven) : oddEven(oddEven) {}
  using Lines<CellT>::grid;
  bool oddEven;
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    grid = {queue, chooseWindowDimensions(n, sizeOf<CellT>(place))};
    return grid.dimensions().cells();
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.sortUntilStable(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) {
    if (oddEven) return grid.transpose(queue, cells, cellOf);
    grid.maintain(queue, cells, cellOf);
  }
  Gather<CellT> search(const CellT* cells) const { return {grid.view(cells)}; }
};

// Calls each(way, structure) with all of them, in the order that numbers them. The first is what the others are
// compared with.
template <class CellT, class Each>
void forEachWay(const Each& each) {
  using bench::kAny, bench::kSlow;
  each(Way{"grid", true, kAny}, Bin<CellT>(1));
  each(Way{"grid, half bins", true, kAny}, Bin<CellT>(2));
  each(Way{"grid, hashed", true, kAny}, Hash<CellT>());
  each(Way{"ngrid, bitonic", true, kAny}, Rows<CellT>(Upkeep::bitonic));
  each(Way{"ngrid, full sort", true, kAny}, Rows<CellT>(Upkeep::full));
  each(Way{"ngrid, packed", true, kAny}, Rows<CellT>(Upkeep::packed));
  each(Way{"ngrid, frozen rows", true, kAny}, Rows<CellT>(Upkeep::frozen));
  each(Way{"thesis: fixed 4, bitonic", false, kAny}, Windows<CellT, FixedGather>(false));
  each(Way{"thesis: fixed 4, odd-even", false, kAny}, Windows<CellT, FixedGather>(true));
  each(Way{"thesis: adaptive, bitonic", false, kAny}, Windows<CellT, AdaptiveGather>(false));
  each(Way{"thesis: adaptive, odd-even", false, kAny}, Windows<CellT, AdaptiveGather>(true));
  each(Way{"brute force", true, kSlow}, Brute<CellT>());
}

// One item: one entity's new place, wherever its cell is.
template <class CellT>
struct MoveTo {
  CellT* cells;
  const uint32_t* cellOf;
  const CellT* byId;
  GW_BODY void operator()(uint32_t id) const { cells[cellOf[id]] = byId[id]; }
};

// The entities in the first cells, the rest dead.
template <class CellT>
void fill(Buffer<CellT>& cells, Buffer<uint32_t>& cellOf, const std::vector<CellT>& byId) {
  std::vector<CellT> all = byId;
  std::vector<uint32_t> own(cells.size());
  for (uint32_t i = 0; i < own.size(); ++i) {
    if (i >= byId.size()) all.push_back(deadCell(CellT{}, i));
    own[i] = i;
  }
  cells.upload(all);
  cellOf.upload(own);
}

template <class CellT>
std::vector<Way> waysOf() {
  std::vector<Way> all;
  forEachWay<CellT>([&](const Way& way, auto&&) { all.push_back(way); });
  return all;
}

}  // namespace gw::GW_DEVICE::ways
