// What gpu/ has to compute, written a second time: plain host code that shares no function with it.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::naive {

test::Words scan(const test::Words& in);   // what stands before each item, then the total
test::Words foldLines(test::Words lines);  // Probes::foldLines

bool isDead(const Cell& cell);

// The order of a line: along one axis, then the other, then by id.
void sortByX(std::vector<Cell>& line);
void sortByY(std::vector<Cell>& line);

// The whole of upkeep, and what it says about the rows of an arrangement.
test::GridState upkeep(test::GridShape shape, std::vector<Cell> cells, test::Upkeep upkeep);

// One call of partial odd-even transposition: an odd and an even pass down every column, then along every row.
std::vector<Cell> transpose(test::GridShape shape, std::vector<Cell> cells);

// Ids of the living within the radius, ascending: the neighbour test on every cell.
std::vector<uint32_t> neighbours(const std::vector<Cell>& cells, test::Query query);

std::vector<uint32_t> neighbours(const std::vector<Cell3>& cells, test::Query3 query);

// The cells in the order of their bins, those of a bin in the order they had, the dead last.
test::Binned binCells(const std::vector<Cell>& cells);
// The indexes of the cells in the order of their buckets, of as many as there are cells, the dead last.
test::Binned hashCells(const std::vector<Cell>& cells);

// A fixed window of the thesis: who is within the radius among the cells at most `columns` and `rows` away
// from the cell (its extended Moore neighbourhood), ids ascending.
std::vector<uint32_t> windowNeighbours(test::GridShape shape, const std::vector<Cell>& arranged, uint32_t cell,
                                       uint32_t columns, uint32_t rows, float radius);

// The adaptive window of the thesis: each of the four directions grows from the cell until the distance
// along its axis passes the radius; the window is what they span.
std::vector<uint32_t> adaptiveNeighbours(test::GridShape shape, const std::vector<Cell>& arranged, uint32_t cell,
                                         float radius);

}  // namespace gw::naive
