// How the lines of an axis lie in memory, and how they are dealt out to teams. Not for users of the NGrid.
//
//   rows      of a slab   begin a row apart,  go on by 1         A team on cuda has as many neighbouring lines of a
//   columns   of a slab   begin side by side, go on by a row     plane as it has room for. A team on cpu has one lane,
//   poles     of all      begin side by side, go on by a slab    and one row, or a cache line's width of the others.
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/ngrid_dimensions.h>

namespace gw::GW_DEVICE {

struct Lines {
  uint32_t length, toNext;           // cells of a line; from one to the next
  uint32_t perPlane, toLine, plane;  // lines of a plane; from one to the next; from one plane to the next
  uint32_t planes;
};

GW_FN Lines rowsOf(NDimensions d) {
  return {d.columns, 1, d.rows, d.columns, d.columns * d.rows, d.slabs};
}
GW_FN Lines columnsOf(NDimensions d) {
  return {d.rows, d.columns, d.columns, 1, d.columns * d.rows, d.slabs};
}
GW_FN Lines polesOf(NDimensions d) {
  return {d.slabs, d.columns * d.rows, d.columns * d.rows, 1, 0, 1};
}

// The lines of one team.
struct LineTile {
  uint32_t plane, first, count;  // of the plane: the first line, how many
};

// `each` lines a team.
GW_FN uint32_t tilesPerPlane(const Lines& lines, uint32_t each) {
  return (lines.perPlane + each - 1) / each;
}
GW_FN LineTile tileOf(const Lines& lines, uint32_t each, uint32_t team) {
  const uint32_t tiles = tilesPerPlane(lines, each), first = team % tiles * each;
  return {team / tiles, first, smaller(each, lines.perPlane - first)};
}
GW_FN uint32_t beginOf(const Lines& lines, const LineTile& tile, uint32_t line) {
  return tile.plane * lines.plane + (tile.first + line) * lines.toLine;
}

// A team sized by the lines it gets: its cells are held in registers on cuda (kEach a lane), on the stack on cpu. Of
// lines shorter than it holds a team on cuda takes several.
template <uint32_t kCells>
struct LineTeam {
  static constexpr uint32_t kCapacity = kCells;
#if GW_ON_CUDA
  static constexpr uint32_t kEach = 4, kLanes = kCells / kEach;
#else
  static constexpr uint32_t kEach = kCells, kLanes = 1;  // one lane walks along its lines
#endif
#if GW_ON_CUDA
  // Places that a line takes: a power of two.
  GW_FN static uint32_t stretchOf(uint32_t length) {
    uint32_t stretch = kEach;
    while (stretch < length) stretch *= 2;
    return stretch;
  }
  GW_FN static uint32_t linesPerTeam(uint32_t length) {
    return kCells / stretchOf(length);
  }
#else
  static uint32_t linesPerTeam(uint32_t) {
    return 1;
  }
#endif
};

// Calls launch with the smallest team that holds a line of so many cells, at most kLongestLine.
template <class Launch>
void withTeamFor(uint32_t length, const Launch& launch) {
#if GW_ON_CUDA
  if (length <= 512) return launch(LineTeam<512>{});
  if (length <= 1024) return launch(LineTeam<1024>{});
#endif
  if (length <= 2048) return launch(LineTeam<2048>{});
  launch(LineTeam<kLongestLine>{});
}

}  // namespace gw::GW_DEVICE
