// What is known of the rows together, found by one team once all rows have been written: how far those up to each row
// and from it on reach, where to begin for a part of y (in 3D of z too), and the totals. Not for users of the NGrid.
//
//   row          0    1    2    3
//   highest y    3    2    7    6        reach.high   3 3 7 7   of this and earlier rows: ascends
//   lowest y     0    1    1    5        reach.low    0 1 1 5   of this and later rows: ascends
#pragma once

#include <gpuwars/ngrid.h>

#include "ngrid_rows.h"

namespace gw::GW_DEVICE {

// For each of `parts` parts the first of `count` rows, or slabs, that reaches into it or beyond.
template <class HighOf>
GW_BODY void indexReach(uint16_t* firstOf, uint32_t parts, Scale scale, uint32_t count, uint32_t lane, uint32_t lanes,
                        const HighOf& highOf) {
  for (uint32_t part = lane; part < parts; part += lanes) {
    uint32_t begin = 0, rest = count;
    while (rest > 1) {
      const uint32_t half = rest / 2;
      begin += partOf(scale, parts, highOf(begin + half - 1)) < part ? half : 0;
      rest -= half;
    }
    firstOf[part] = uint16_t(begin);
  }
}

GW_BODY inline GridTotals addedUp(GridTotals a, const GridTotals& b) {
  a.height += b.height;
  a.x = joined(a.x, b.x);
  a.y = joined(a.y, b.y);
  a.z = joined(a.z, b.z);
  a.moved += b.moved;
  return a;
}

GW_BODY inline GridTotals noTotals() {
  GridTotals none{};
  none.x = none.y = none.z = {kInfinity, -kInfinity};
  return none;
}

struct FindReach {
  // Rows of a slab are added up strip by strip: as many on either device, since sums of floats depend on who adds what.
  static constexpr uint32_t kStrips = 64;
  struct Shared {
    GridTotals strip[kStrips];
    Interval y[kStrips];
  };
  Interval* reach;                  // [lines]
  uint16_t *firstRow, *firstSlab;   // the latter null in 2D
  GridSlab* slab;                   // [slabs]
  GridTotals *slabTotals, *totals;  // [slabs], null in 2D; of all
  RowsFound found;
  uint32_t rows, slabs, built;

  // Of one slab; of a flat grid also what is known of the whole.
  template <uint32_t kLanes, class Team>
  GW_BODY void ofSlab(const Team& team, Shared& s, uint32_t which) const {
    const uint32_t each = (rows + kStrips - 1) / kStrips, base = which * rows;
    const auto forEachStrip = [&](const auto& body) {
      team.phase([&](uint32_t lane) {
        for (uint32_t strip = lane; strip < kStrips; strip += kLanes) {
          body(strip, base + smaller(strip * each, rows), base + smaller((strip + 1) * each, rows));
        }
      });
    };
    forEachStrip([&](uint32_t strip, uint32_t begin, uint32_t end) {
      GridTotals mine = noTotals();
      for (uint32_t line = begin; line < end; ++line) mine = addedUp(mine, totalsOf(line));
      s.strip[strip] = mine;
      s.y[strip] = mine.y;
    });
    forEachStrip([&](uint32_t strip, uint32_t begin, uint32_t end) {
      float most = -kInfinity, least = kInfinity;
      for (uint32_t other = 0; other < strip; ++other) most = larger(most, s.y[other].high);
      for (uint32_t other = strip + 1; other < kStrips; ++other) least = smaller(least, s.y[other].low);
      for (uint32_t line = begin; line < end; ++line) reach[line].high = most = larger(most, found.height[line].high);
      for (uint32_t line = end; line > begin; --line) {
        reach[line - 1].low = least = smaller(least, found.height[line - 1].low);
      }
    });
    for (uint32_t half = kStrips / 2; half > 0; half /= 2) {
      forEachStrip([&](uint32_t strip, uint32_t, uint32_t) {
        if (strip < half) s.strip[strip] = addedUp(s.strip[strip], s.strip[strip + half]);
      });
    }
    team.phase([&](uint32_t lane) {
      const uint32_t parts = rows * kPartsPerRow;
      const GridTotals& all = s.strip[0];
      indexReach(firstRow + which * parts, parts, scaleOf(all.y, parts), rows, lane, kLanes,
                 [&](uint32_t row) { return reach[base + row].high; });
      if (lane != 0) return;
      slab[which].rows = scaleOf(all.y, parts);
      if (slabTotals) {
        slabTotals[which] = all;
      } else {
        writeTotals(all);
      }
    });
  }

  // In 3D, once all slabs have been seen: the same over slabs.
  template <uint32_t kLanes, class Team>
  GW_BODY void ofAllSlabs(const Team& team) const {
    team.phase([&](uint32_t lane) {
      if (lane != 0) return;
      GridTotals all = noTotals();
      for (uint32_t i = 0; i < slabs; ++i) {
        all = addedUp(all, slabTotals[i]);
        slab[i].reach.high = all.z.high;
      }
      float least = kInfinity;
      for (uint32_t i = slabs; i > 0; --i) slab[i - 1].reach.low = least = smaller(least, slabTotals[i - 1].z.low);
      all.slabs = scaleOf(all.z, slabs * kPartsPerRow);
      writeTotals(all);
    });
    team.phase([&](uint32_t lane) {
      indexReach(firstSlab, slabs * kPartsPerRow, totals->slabs, slabs, lane, kLanes,
                 [&](uint32_t i) { return slab[i].reach.high; });
    });
  }

 private:
  GW_BODY GridTotals totalsOf(uint32_t line) const {
    const Interval y = found.height[line];
    GridTotals mine = noTotals();
    mine.height = y.high > y.low ? y.high - y.low : 0.0f;
    mine.x = found.width[line];
    mine.y = y;
    if (found.depth) mine.z = found.depth[line];
    mine.moved = found.moved[line];
    return mine;
  }

  // `all` replaces what the upkeep before has left.
  GW_BODY void writeTotals(GridTotals all) const {
    all.heightBuilt = built ? all.height : totals->heightBuilt;
    all.parts = scaleOf(totals->x, found.parts);  // by which the rows were indexed
    *totals = all;
  }
};

}  // namespace gw::GW_DEVICE
