// What the NGrid has to do, written a second time: plain host code that shares no function with it, in two and three
// dimensions alike.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::naive {

// The order of a line: along one axis (0 x, 1 y, 2 z), then along the others (x, y, z; y, x, z; z, y, x), then by id.
template <class CellT>
void sortAlong(std::vector<CellT>& line, int axis);

// The whole of upkeep, and what it says about the rows of an arrangement. Of transpose and repack only one call.
template <class CellT>
test::GridStateOf<CellT> upkeep(test::GridShape shape, std::vector<CellT> cells, test::Upkeep upkeep);

// Empty when both are the same, else the first thing in which they differ.
template <class CellT>
std::string difference(const test::GridStateOf<CellT>& expected, const test::GridStateOf<CellT>& actual);

// Living cells that stand before their predecessor on a line of any axis.
template <class CellT>
uint32_t misaligned(test::GridShape shape, const std::vector<CellT>& cells);

// The mean distance between living neighbours on the lines of an axis.
template <class CellT>
double meanStep(test::GridShape shape, const std::vector<CellT>& cells, int axis);

// A fixed window of the thesis: who is within the radius among the cells at most so many away from the cell along
// each axis (its extended Moore neighbourhood), ids ascending.
template <class CellT>
std::vector<uint32_t> windowNeighbours(test::GridShape shape, const std::vector<CellT>& arranged, uint32_t cell,
                                       const uint32_t (&away)[3], float radius);

// The adaptive window of the thesis: each direction grows from the cell until the distance along its axis passes
// the radius; the window is what they span.
template <class CellT>
std::vector<uint32_t> adaptiveNeighbours(test::GridShape shape, const std::vector<CellT>& arranged, uint32_t cell,
                                         float radius);

}  // namespace gw::naive
