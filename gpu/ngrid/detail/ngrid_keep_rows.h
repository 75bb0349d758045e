// The launch that ends every upkeep with rows known: puts each row in order, tells where each id now stands, and finds
// what there is to know of the rows, each and all together. Not for users of the NGrid.
#pragma once

#include <gpuwars/last_team.h>

#include "ngrid_lines.h"
#include "ngrid_reach.h"
#include "ngrid_row_order.h"
#include "ngrid_rows.h"

namespace gw::GW_DEVICE {

// One team: neighbouring rows of a slab. The last team of a slab goes on with the slab, the last slab's with the grid.
template <class CellT, class LineTeamT, template <class, class> class RowsInOrder>
struct KeepRows {
  using Rows = RowsInOrder<CellT, LineTeamT>;
  static constexpr uint32_t kLanes = LineTeamT::kLanes;
  struct Shared {
    union {
      typename Rows::Shared rows;
      FindReach::Shared reach;
    };
    uint32_t isLast;
  };
  CellT* cells;
  const CellT* from;  // cells, or others
  uint32_t* cellOf;
  FindReach reach;
  uint32_t* arrived;  // [1 + slabs]: slabs, and teams of each
  const uint32_t* hold;
  Lines lines;

  GW_MEMBER uint32_t rowsPerTeam() const { return LineTeamT::linesPerTeam(lines.length); }
  uint32_t teams() const { return tilesPerPlane(lines, rowsPerTeam()) * lines.planes; }

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;  // all teams alike
    const RowsFound& found = reach.found;
    const LineTile tile = tileOf(lines, rowsPerTeam(), team.index);
    const uint32_t mine = Rows::lineOf(lines.length);  // of the tile; some lanes may have none
    const uint32_t row = tile.plane * lines.perPlane + tile.first + mine, begin = row * lines.length;
    const Rows rows(
        s.rows,
        {cells + begin, from + begin, mine < tile.count ? lines.length : 0,
         found.firstColumn + size_t(row) * (found.parts + 1), scaleOf(found.before->x, found.parts), found.parts},
        lines.length);
    LivingBox box = LivingBox::nothing();
    rows.put([&](uint32_t column, const CellT& cell) {
      box.take(cell);
      box.moved += cellOf[cell.id] != begin + column;
      cellOf[cell.id] = begin + column;
    });
    if (rows.join(box)) writeRow(found, row, box);
    rows.index();
    if (!isLastTeam(team, s.isLast, arrived + 1 + tile.plane, tilesPerPlane(lines, rowsPerTeam()))) return;
    reach.template ofSlab<kLanes>(team, s.reach, tile.plane);
    if (kFlat<CellT> || !isLastTeam(team, s.isLast, arrived, lines.planes)) return;
    reach.template ofAllSlabs<kLanes>(team);
  }
};

}  // namespace gw::GW_DEVICE
