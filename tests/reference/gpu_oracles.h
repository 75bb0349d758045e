// What gpu/ has to compute, written a second time: plain host code that shares no function with it.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::naive {

test::Words scan(const test::Words& in);   // what stands before each item, then the total
test::Words foldLines(test::Words lines);  // Probes::foldLines

bool isDead(const Cell& cell);

// Ids of the living within the radius, ascending: the neighbour test on every cell.
std::vector<uint32_t> neighbours(const std::vector<Cell>& cells, test::Query query);

std::vector<uint32_t> neighbours(const std::vector<Cell3>& cells, test::Query3 query);

// The cells in the order of their bins, those of a bin in the order they had, the dead last.
test::Binned binCells(const std::vector<Cell>& cells);
// The indexes of the cells in the order of their buckets, of as many as there are cells, the dead last.
test::Binned hashCells(const std::vector<Cell>& cells);

}  // namespace gw::naive
