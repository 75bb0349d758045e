// The neighbours of every entity, stored: for code that reads them several times, or hands them on. Code that reads
// once needs no lists: a visitor in a kernel reads and writes less.
//
//   id            0        1     2          begin()       0 2 3 6
//   neighbours()  4 7      0     1 3 9      of id 2: neighbours()[3 .. 6)
//
// A list holds ids in ascending order, without the entity itself, so that it is the same on every device and with
// every exact search, however the cells are arranged. The dead have empty lists. One launch counts, four add
// up, one fills: O(searches + sorting of the lists).
#pragma once

#include <gpuwars/neighbour.h>
#include <gpuwars/scan_reduce.h>

namespace gw::GW_DEVICE {

// Throws std::invalid_argument unless radius is finite and at least 0 m, and the buffer is not null.
void requireListable(float radius, const void* d_cells);

// Ascending, in place: heapsort (Williams 1964) for a long list, insertion for the usual.
GW_FN void sortIds(uint32_t* ids, uint32_t count) {
  constexpr uint32_t kUsual = 48;
  if (count <= kUsual) {
    for (uint32_t i = 1; i < count; ++i) {
      const uint32_t id = ids[i];
      uint32_t hole = i;
      for (; hole > 0 && ids[hole - 1] > id; --hole) ids[hole] = ids[hole - 1];
      ids[hole] = id;
    }
    return;
  }
  for (uint32_t top = count / 2, end = count; end > 1;) {
    uint32_t sinking;
    if (top > 0) {
      sinking = ids[--top];  // still making the heap
    } else {
      sinking = ids[--end];
      ids[end] = ids[0];
    }
    uint32_t hole = top;
    for (uint32_t child = 2 * hole + 1; child < end; child = 2 * hole + 1) {
      child += child + 1 < end && ids[child + 1] > ids[child];
      if (ids[child] <= sinking) break;
      ids[hole] = ids[child];
      hole = child;
    }
    ids[hole] = sinking;
  }
}

// One item: one cell.
template <class CellT, class Search>
struct CountListed {
  uint64_t* counts;  // [ids]
  const CellT* cells;
  Search search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    uint64_t count = 0;
    if (isLiving(self.x)) {
      search.around(i, placeOf(self), radius,
                    [&](const CellT&, uint32_t index, PlaceOf<CellT>) { count += index != i; });
    }
    counts[self.id] = count;
  }
};

// One item: one cell.
template <class CellT, class Search>
struct FillListed {
  uint32_t* neighbours;
  const uint32_t* begin;  // [ids + 1]
  const CellT* cells;
  Search search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    if (!isLiving(self.x)) return;
    uint32_t* const mine = neighbours + begin[self.id];
    uint32_t count = 0;
    search.around(i, placeOf(self), radius, [&](const CellT& cell, uint32_t index, PlaceOf<CellT>) {
      if (index != i) mine[count++] = cell.id;
    });
    sortIds(mine, count);
  }
};

// The lists, with the memory to make them. Its queue outlives it.
class NeighbourLists {
 public:
  NeighbourLists() = default;
  // For grids of `cells` cells, at least 1, and `capacity` neighbours in all; else std::invalid_argument.
  NeighbourLists(Queue& queue, uint32_t cells, uint32_t capacity);

  const uint32_t* begin() const { return begin_.data(); }            // [cells + 1], by id
  const uint32_t* neighbours() const { return neighbours_.data(); }  // [total()] ids
  // Neighbours in all lists.
  uint32_t total() const { return total_; }
  // The same on the host. Wait for the queue.
  std::vector<uint32_t> downloadBegin() const { return begin_.download(); }
  // [total()] ids.
  std::vector<uint32_t> downloadNeighbours() const;
  size_t bytes() const;  // of device memory held

  // Lists the pairs within radius (m) of each other by any of the searches, whose cells these are. Waits for the queue.
  // Throws std::invalid_argument when the radius is negative, infinite or not a number or d_cells is null, and
  // std::length_error, naming the total, when it is more than the capacity: then the lists stay as they were.
  template <class Search, class CellT>
  void build(Queue& queue, const Search& search, const CellT* d_cells, float radius) {
    requireListable(radius, d_cells);
    const Count all{cells_};
    forEach(queue, all, CountListed<CellT, Search>{counts_.data(), d_cells, search, radius});
    addUp(queue);
    forEach(queue, all, FillListed<CellT, Search>{neighbours_.data(), begin_.data(), d_cells, search, radius});
    queue.synchronise();
  }

 private:
  void addUp(Queue& queue);

  uint32_t cells_ = 0, total_ = 0;
  Buffer<uint64_t> counts_;
  Scan before_;
  Buffer<uint32_t> begin_, neighbours_;
};

}  // namespace gw::GW_DEVICE
