// Stable sort of items by small keys, their bins: the order is by bin, and within a bin as it was, so it is unique
// and each device uses what suits it: CUB's radix sort on cuda, counting by slices on cpu.
//
//   bins of the items   2 0 1 0 2 1           begin()  0  2  4  6
//   order               1 3 | 2 5 | 0 4                bin 0, 1, 2
//
// On cpu the items are cut into slices, each of which counts its own bins (Knuth, TAOCP 5.2 D); a scan over the
// bins, and within a bin over the slices, tells each slice where its items of each bin go. O(count + slices * bins),
// four launches. On cuda two and those of the sort (sort_keys.cu), and one for begin().
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/buffer.h>
#if GW_ON_CUDA
#include <gpuwars/sort_keys.h>
#endif

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

template <class Binner>
struct FillBinKeys {
  uint64_t* keys;
  Binner binOf;
  GW_BODY void operator()(uint32_t i) const { keys[i] = uint64_t(binOf(i)) << 32 | i; }
};

template <class Mover>
struct MoveByKeys {
  const uint64_t* keys;
  Mover move;
  GW_BODY void operator()(uint32_t to) const { move(uint32_t(keys[to]), to); }
};

#else

// One team: one slice of the items.
template <class Binner>
struct CountSlice {
  static constexpr uint32_t kLanes = 1;
  struct Shared {};
  uint32_t *counts, *binOfItem;
  uint32_t items, perSlice, bins;
  Binner binOf;

  template <class Team>
  void operator()(const Team& team, Shared&) const {
    uint32_t* mine = counts + size_t(team.index) * bins;
    for (uint32_t b = 0; b < bins; ++b) mine[b] = 0;
    const uint32_t end = smaller((team.index + 1) * perSlice, items);
    for (uint32_t i = team.index * perSlice; i < end; ++i) ++mine[binOfItem[i] = binOf(i)];
  }
};

template <class Mover>
struct ScatterSlice {
  static constexpr uint32_t kLanes = 1;
  struct Shared {};
  uint32_t* next;  // [slice][bin] where its next item goes
  const uint32_t* binOfItem;
  uint32_t items, perSlice, bins;
  Mover move;

  template <class Team>
  void operator()(const Team& team, Shared&) const {
    uint32_t* mine = next + size_t(team.index) * bins;
    const uint32_t end = smaller((team.index + 1) * perSlice, items);
    for (uint32_t i = team.index * perSlice; i < end; ++i) move(i, mine[binOfItem[i]]++);
  }
};

#endif

// The sort, with the memory that it works in. Its queue outlives it.
class BinSort {
 public:
  BinSort() = default;
  // count items, 1 to 2^31; bins, 1 to 2^31. On cuda begin() is a launch: only who wants it pays for it.
  BinSort(Queue& queue, uint32_t count, uint32_t bins, bool wantsBegin = true);

  // [bins + 1] where each bin begins in the order; the last is count. Written by run(), when wanted.
  const uint32_t* begin() const { return begin_.data(); }
  // As it was made for.
  uint32_t bins() const { return bins_; }
  size_t bytes() const;  // of device memory held

  // Calls binOf(i), which returns the bin of item i (below bins), once for each item, and after all of these
  // move(from, to), once for each: the item `from` belongs at place `to`. Both are kernels of one item, copied.
  template <class Binner, class Mover>
  void run(Queue& queue, const Binner& binOf, const Mover& move) {
#if GW_ON_CUDA
    forEach(queue, Count{count_}, FillBinKeys<Binner>{keys_.keys(), binOf});
    sort(queue);
    forEach(queue, Count{count_}, MoveByKeys<Mover>{keys_.keys(), move});
#else
    forEachTeam(queue, slices_, CountSlice<Binner>{counts_.data(), binOfItem_.data(), count_, perSlice_, bins_, binOf});
    scan(queue);
    forEachTeam(queue, slices_, ScatterSlice<Mover>{counts_.data(), binOfItem_.data(), count_, perSlice_, bins_, move});
#endif
  }

 private:
  uint32_t count_ = 0, bins_ = 0;
  Buffer<uint32_t> begin_;  // empty on cuda when not wanted
#if GW_ON_CUDA
  void sort(Queue& queue);
  SortKeys keys_;
#else
  void scan(Queue& queue);
  uint32_t slices_ = 0, perSlice_ = 0;
  Buffer<uint32_t> counts_, binOfItem_, ranges_;
#endif
};

}  // namespace gw::GW_DEVICE
