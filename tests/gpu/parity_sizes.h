// How much the parity cases compare: all of it on a GPU, less on the PTX machine, which parity_test's options say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::test {

struct ParitySizes {
  size_t items = std::numeric_limits<size_t>::max();  // of an input of a primitive, at most
  uint32_t enemies = 2048, ticks = 300;               // of a game...
  uint32_t firstTick = 0;                             // ... which goes on from here, where more happens
  std::vector<uint32_t> blockSizes = {64, 128, 256};  // of what runs on cuda
};

ParitySizes& paritySizes();

size_t atMostItems(size_t count);
// Ascending, each cut, and those that are then equal once.
std::vector<uint32_t> atMostItems(std::initializer_list<uint32_t> counts);
// Cut along its shortest axis longer than 1 first, so that the longest lines stay.
GridShape atMostItems(GridShape shape);

}  // namespace gw::test
