// Lines of cells, put in order by a block that holds them in registers. For the cuda device only. Not for users.
//
// What is sorted are keys of 64 bits, and the cells follow once: 8 bytes a cell are exchanged instead of 16, by integer
// comparisons alone. A key says what to go by, and which cell it is:
//
//    63      48 47                    16 15     0
//   +----------+------------------------+--------+     The living by their place along the axis (as an integer of the
//   |    0     |   place along the axis | column |     same order), the dead after them by id. Who is equal in that
//   |    1     |   id of a dead one     | column |     is sorted once more, within the run of equals, by the next axis,
//   +----------+------------------------+--------+     and at last by id: then `run` is where the run begins.
//   |   run    |   what comes next      | column |     Living ones of equal places are rare, so one sort is the rule.
//   +----------+------------------------+--------+
#pragma once

#include <gpuwars/block_sort.h>

#include "line_order.h"
#include "ngrid_lines.h"

#if GW_ON_CUDA

namespace gw::GW_DEVICE {

// A lane's share of a line: kEach cells, `lanes` lanes apart. All of a block make theirs, and call what they call,
// together.
template <class CellT, class LineTeamT>
class BlockLines {
  static constexpr uint32_t kEach = LineTeamT::kEach, kLanes = LineTeamT::kLanes;
  using ByPlace = BlockSort<uint64_t, kLanes, kEach>;
  using ByPart = BlockSort<uint32_t, kLanes, kEach>;
  static_assert(kLongestLine <= 1u << 13, "a key by part has 13 bits for the column");

 public:
  struct Shared {
    union {
      typename ByPlace::Shared byPlace;
      typename ByPart::Shared byPart;
      uint16_t places[LineTeamT::kCapacity];  // what is known of each place, line after line
    };
    uint32_t ofWarp[kLanes / kWarp];
  };

  // Which line of the team's a lane has a share of.
  GW_BODY static uint32_t lineOf(uint32_t length) { return threadIdx.x * kEach / LineTeamT::stretchOf(length); }

  // A lane's line: cells first[0], first[toNext], ...; length 0 for lanes that have none. `longest` is what the lines
  // of the block are assumed to have.
  GW_BODY BlockLines(Shared& shared, const CellT* d_first, uint32_t length, uint32_t toNext, uint32_t longest)
      : s(shared),
        from(d_first),
        length(length),
        toNext(toNext),
        stretch(LineTeamT::stretchOf(longest)),
        lanes(stretch / kEach),
        lane(threadIdx.x & (lanes - 1)),
        firstPlace((threadIdx.x - lane) * kEach) {}

  // Puts the line into the total order of Less.
  template <class Less>
  GW_BODY void sort(Less less) {
    uint64_t key[kEach];
    for (uint32_t e = 0; e < kEach; ++e) {
      const uint32_t column = columnOf(e);
      key[e] = column < length ? firstKey(less, cellAt(column), column) : kPadding;
    }
    constexpr uint32_t kTurns = kFlat<CellT> ? 2 : 3;  // the other axes, the id
    for (uint32_t turn = 0;; ++turn) {
      ByPlace::run(key, s.byPlace, stretch);
      if (turn == kTurns || !anyEqual(key)) break;
      markRuns(key);
      for (uint32_t e = 0; e < kEach; ++e) {
        if (key[e] == kPadding) continue;
        const CellT cell = cellAt(uint16_t(key[e]));
        const uint32_t next = turn + 1 == kTurns ? cell.id : placeBits(less.across(cell, turn == 1));
        key[e] = (key[e] & ~kWhatMask) | uint64_t(next) << 16;
      }
    }
    take([&](uint32_t e) { return uint16_t(key[e]); });
  }

  // Puts the line into the order of the parts, below 2^19, that partOf(cell) tells; each part in the order it had.
  template <class PartOf>
  GW_BODY void sortByParts(const PartOf& partOf) {
    uint32_t key[kEach];
    for (uint32_t e = 0; e < kEach; ++e) {
      const uint32_t column = columnOf(e);
      key[e] = column < length ? partOf(cellAt(column)) << 13 | column : 0xFFFFFFFFu;
    }
    ByPart::run(key, s.byPart, stretch);
    take([&](uint32_t e) { return uint16_t(key[e] & ((1u << 13) - 1)); });
  }

  // Calls visit(column, cell) for the lane's share of the line in order. By now the line's cells are no longer read,
  // so it may be written. What visit returns is told to neighbours: see note().
  template <class Visit>
  GW_BODY void forEach(const Visit& visit) const {
    for (uint32_t e = 0; e < kEach; ++e) {
      if (columnOf(e) < length) visit(columnOf(e), cell[e]);
    }
  }

  // A note of 16 bits for each column of the line, to be read by other lanes after __syncthreads().
  GW_BODY uint16_t& note(uint32_t column) const { return s.places[firstPlace + column]; }

  // Joins what the lanes of each line have; whether this is the lane that has it all then. `ofWarp` has room for the
  // block's warps; shuffled(value, bits) returns the value of the lane whose number differs by these bits.
  template <class Joined>
  GW_BODY bool join(Joined& mine, Joined* s_ofWarp) const {
    for (uint32_t apart = smaller(lanes, kWarp) / 2; apart > 0; apart /= 2) mine.join(shuffled(mine, apart));
    if (lanes > kWarp) {  // all lines of a block are as long
      const uint32_t warp = threadIdx.x / kWarp;
      if (threadIdx.x % kWarp == 0) s_ofWarp[warp] = mine;
      __syncthreads();
      if (lane == 0) {
        for (uint32_t w = 1; w < lanes / kWarp; ++w) mine.join(s_ofWarp[warp + w]);
      }
    }
    return lane == 0 && length > 0;
  }

 private:
  static constexpr uint64_t kPadding = ~0ull, kWhatMask = 0xFFFFFFFFull << 16;

  GW_BODY uint32_t columnOf(uint32_t e) const { return e * lanes + lane; }
  GW_BODY CellT cellAt(uint32_t column) const { return from[size_t(column) * toNext]; }

  template <class Less>
  GW_BODY static uint64_t firstKey(Less less, const CellT& cell, uint32_t column) {
    const bool lives = isLiving(cell.x) || isLiving(cell.y) || (!kFlat<CellT> && isLiving(zOf(cell)));
    if (!lives) return 1ull << 48 | uint64_t(cell.id) << 16 | column;  // else it takes its turn among equals
    return uint64_t(placeBits(less.along(cell))) << 16 | column;
  }

  // Whether the lane's e-th key begins a run of equals; `before` is the last key of the lane before.
  GW_BODY bool beginsRun(const uint64_t (&key)[kEach], uint32_t e, uint64_t before) const {
    if (e == 0 && lane == 0) return true;
    return key[e] == kPadding || key[e] >> 16 != (e == 0 ? before : key[e - 1]) >> 16;
  }

  GW_BODY uint64_t lastKeyBefore(const uint64_t (&key)[kEach]) const {
    s.byPlace.key[0][threadIdx.x] = key[kEach - 1];
    __syncthreads();
    return threadIdx.x ? s.byPlace.key[0][threadIdx.x - 1] : kPadding;
  }

  // Of any line of the block.
  GW_BODY bool anyEqual(const uint64_t (&key)[kEach]) const {
    const uint64_t before = lastKeyBefore(key);
    bool equal = false;
    for (uint32_t e = 0; e < kEach; ++e) equal |= !beginsRun(key, e, before);
    return __syncthreads_or(equal);
  }

  // Writes where its run begins above each key: the greatest beginning up to it, which is a scan over the block.
  GW_BODY void markRuns(uint64_t (&key)[kEach]) const {
    const uint64_t before = lastKeyBefore(key);
    const uint32_t inWarp = threadIdx.x % kWarp, warp = threadIdx.x / kWarp;
    bool begins[kEach];
    uint32_t begin = 0;
    for (uint32_t e = 0; e < kEach; ++e) {
      begins[e] = beginsRun(key, e, before);
      if (begins[e]) begin = threadIdx.x * kEach + e;
    }
    for (uint32_t apart = 1; apart < kWarp; apart *= 2) {
      const uint32_t earlier = __shfl_up_sync(kWholeWarp, begin, apart);
      if (inWarp >= apart) begin = larger(begin, earlier);
    }
    if (inWarp == kWarp - 1) s.ofWarp[warp] = begin;
    begin = __shfl_up_sync(kWholeWarp, begin, 1);
    if (inWarp == 0) begin = 0;
    __syncthreads();
    for (uint32_t w = 0; w < warp; ++w) begin = larger(begin, s.ofWarp[w]);
    for (uint32_t e = 0; e < kEach; ++e) {
      if (begins[e]) begin = threadIdx.x * kEach + e;
      if (key[e] != kPadding) key[e] = uint64_t(begin) << 48 | (key[e] & ((1ull << 48) - 1));
    }
  }

  // Fetches the cells by the columns they had, of which a lane knows those of kEach places beside each other.
  template <class ColumnHad>
  GW_BODY void take(const ColumnHad& columnHad) {
    for (uint32_t e = 0; e < kEach; ++e) s.places[threadIdx.x * kEach + e] = columnHad(e);
    __syncthreads();
    for (uint32_t e = 0; e < kEach; ++e) {
      if (columnOf(e) < length) cell[e] = cellAt(s.places[firstPlace + columnOf(e)]);
    }
    __syncthreads();
  }

  Shared& s;
  const CellT* from;
  uint32_t length, toNext, stretch, lanes, lane, firstPlace;
  CellT cell[kEach];
};

}  // namespace gw::GW_DEVICE

#endif
