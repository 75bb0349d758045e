// The two ways in which upkeep puts the cells of a row in order, on either device: sorted by x throughout, or put into
// the parts of x that the row's index is made of, each part in the order it had. Not for users of the NGrid.
//
//   x            .5 .1 .6 .4 .9 .2            parts of x    0    | 1   | 2   | 3
//   SortedRows   .1 .2 .4 .5 .6 .9            PartedRows   .1 .2 | .4  | .5 .6 | .9     and here .2 .1 could be as well
//
// Both are made by all lanes of a team together, and then called in this order: put(), join(), index().
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/ngrid.h>

#include "ngrid_lines.h"
#include "ngrid_rows.h"

#if GW_ON_CUDA
#include "block_lines.h"
#else
#include "line_order.h"
#include "line_sort.h"
#endif

namespace gw::GW_DEVICE {

// One row: where its cells are, and where they go (the same place or another). A lane that has none has one of length
// 0.
template <class CellT>
struct RowToKeep {
  CellT* to;
  const CellT* from;
  uint32_t length;
  uint16_t* firstColumn;  // [parts + 1] its index
  Scale scale;            // of its parts of x
  uint32_t parts;

  GW_BODY uint32_t partOfCell(const CellT& cell) const {
    return isLiving(cell.x) ? partOf(scale, parts, cell.x) : parts;  // the dead are behind the last
  }
};

#if GW_ON_CUDA

// What the lane of the warp has whose number differs by `bits`.
GW_BODY inline LivingBox shuffled(const LivingBox& mine, uint32_t bits) {
  const auto of = [&](auto value) { return __shfl_xor_sync(kWholeWarp, value, int(bits)); };
  return {{of(mine.x.low), of(mine.x.high)},
          {of(mine.y.low), of(mine.y.high)},
          {of(mine.z.low), of(mine.z.high)},
          of(mine.living),
          of(mine.moved)};
}

template <class CellT, class LineTeamT, bool kByParts>
class RowsOfBlock {
  using Lines = BlockLines<CellT, LineTeamT>;

 public:
  struct Shared {
    typename Lines::Shared lines;
    LivingBox ofWarp[LineTeamT::kLanes / kWarp];
  };

  GW_BODY static uint32_t lineOf(uint32_t length) { return Lines::lineOf(length); }

  GW_BODY RowsOfBlock(Shared& shared, const RowToKeep<CellT>& ofLane, uint32_t longest)
      : s(shared), row(ofLane), lines(shared.lines, ofLane.from, ofLane.length, 1, longest) {
    if constexpr (kByParts) {
      lines.sortByParts([&](const CellT& cell) { return row.partOfCell(cell); });
    } else {
      lines.sort(ByX{});
    }
  }

  template <class Visit>
  GW_BODY void put(const Visit& visit) const {
    lines.forEach([&](uint32_t column, const CellT& cell) {
      row.to[column] = cell;
      lines.note(column) = uint16_t(row.partOfCell(cell));
      visit(column, cell);
    });
  }

  GW_BODY bool join(LivingBox& box) const { return lines.join(box, s.ofWarp); }

  // Lane by lane: the parts that begin at each cell, then those after the last.
  GW_BODY void index() const {
    __syncthreads();
    lines.forEach([&](uint32_t column, const CellT&) {
      const uint32_t part = lines.note(column);
      for (uint32_t p = column == 0 ? 0 : lines.note(column - 1) + 1; p <= part; ++p) {
        row.firstColumn[p] = uint16_t(column);
      }
      if (column + 1 < row.length) return;
      for (uint32_t p = part + 1; p <= row.parts; ++p) row.firstColumn[p] = uint16_t(row.length);
    });
  }

 private:
  Shared& s;
  RowToKeep<CellT> row;
  Lines lines;
};

template <class CellT, class LineTeamT>
using SortedRows = RowsOfBlock<CellT, LineTeamT, false>;
template <class CellT, class LineTeamT>
using PartedRows = RowsOfBlock<CellT, LineTeamT, true>;

#else

// A team has one row and one lane.
template <class CellT>
class RowOfLane {
 public:
  static uint32_t lineOf(uint32_t) { return 0; }
  explicit RowOfLane(const RowToKeep<CellT>& row) : row(row) {}
  bool join(LivingBox&) const { return true; }

 protected:
  RowToKeep<CellT> row;
};

// Sorted where it stands.
template <class CellT, class LineTeamT>
class SortedRows : public RowOfLane<CellT> {
  using RowOfLane<CellT>::row;

 public:
  struct Shared {};

  SortedRows(Shared&, const RowToKeep<CellT>& row, uint32_t) : RowOfLane<CellT>(row) {
    sortLine(row.to, row.length, ByX{});
  }

  template <class Visit>
  void put(const Visit& visit) const {
    for (uint32_t c = 0; c < row.length; ++c) visit(c, row.to[c]);
  }

  void index() const {
    uint32_t next = 0;  // part without a first column yet
    for (uint32_t c = 0; c < row.length && next <= row.parts; ++c) {
      for (const uint32_t part = row.partOfCell(row.to[c]); next <= part; ++next) row.firstColumn[next] = uint16_t(c);
    }
    for (; next <= row.parts; ++next) row.firstColumn[next] = uint16_t(row.length);
  }
};

// Counted: how many each part has says where it begins.
template <class CellT, class LineTeamT>
class PartedRows : public RowOfLane<CellT> {
  using RowOfLane<CellT>::row;
  static constexpr uint32_t kMostParts = LineTeamT::kCapacity + LineTeamT::kCapacity / 2;

 public:
  struct Shared {
    CellT line[LineTeamT::kCapacity];
    uint32_t part[LineTeamT::kCapacity], next[kMostParts + 1];
  };

  PartedRows(Shared& shared, const RowToKeep<CellT>& row, uint32_t) : RowOfLane<CellT>(row), s(shared) {
    std::copy(row.from, row.from + row.length, s.line);
    std::fill(s.next, s.next + row.parts + 1, 0u);
    for (uint32_t c = 0; c < row.length; ++c) s.part[c] = row.partOfCell(s.line[c]);
    for (uint32_t c = 0; c < row.length; ++c) ++s.next[s.part[c]];
    uint32_t at = 0;
    for (uint32_t p = 0; p <= row.parts; ++p) {
      const uint32_t count = s.next[p];
      row.firstColumn[p] = uint16_t(at);
      s.next[p] = at;
      at += count;
    }
  }

  template <class Visit>
  void put(const Visit& visit) const {
    for (uint32_t c = 0; c < row.length; ++c) {
      const uint32_t to = s.next[s.part[c]]++;
      row.to[to] = s.line[c];
      visit(to, s.line[c]);
    }
  }

  void index() const {}  // counting has told it

 private:
  Shared& s;
};

#endif

}  // namespace gw::GW_DEVICE
