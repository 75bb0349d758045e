// Arrangements of cells to try things on, and places to search from.
#pragma once

#include <ostream>
#include <random>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::test {

enum class Layout : uint32_t {
  uniform,     // a square of 100 m
  clustered,   // eight heaps
  line,        // all at one y
  coincident,  // few places, many at each
  lattice,     // whole metres: ties and exact boundaries everywhere
  huge,        // up to 1e30 m
  nearOrigin,  // around 0, where differences of floats are rounded
  zeros,       // +0 and -0 and the smallest floats
};
inline constexpr uint32_t kLayouts = 8;

struct CellSpec {
  Layout layout = Layout::uniform;
  GridShape shape;
  uint32_t deadPercent = 0;
  uint64_t seed = 1;
};
std::ostream& operator<<(std::ostream& out, const CellSpec& spec);

// Ids 0 .. cells - 1 in the order of cells; the type of id i is 7 * i + 1.
std::vector<Cell> makeCells(const CellSpec& spec);

// The same in three dimensions: z is another draw of what makes x.
std::vector<Cell3> makeCells3(const CellSpec& spec);

// Moves every living cell by up to `step` along each axis; kills and revives some.
void moveCells(std::vector<Cell>& cells, float step, uint64_t seed);
void moveCells(std::vector<Cell3>& cells, float step, uint64_t seed);

// Places of entities and others; radii from nothing to everything, half of them such that an entity stands
// exactly on the boundary.
std::vector<Query> makeQueries(const std::vector<Cell>& cells, uint32_t count, uint64_t seed);

std::vector<Query3> makeQueries3(const std::vector<Cell3>& cells, uint32_t count, uint64_t seed);

// `count` words with every kind of value: zeros, ones, small, all bits.
Words makeWords(size_t count, uint64_t seed);

// Like std::uniform_real_distribution, whose results differ between libraries.
float between(std::mt19937_64& random, float low, float high);

}  // namespace gw::test
