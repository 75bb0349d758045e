#include "tests/gpu/parity_sizes.h"

#include <algorithm>
#include <set>

namespace gw::test {

ParitySizes& paritySizes() {
  static ParitySizes sizes;
  return sizes;
}

size_t atMostItems(size_t count) {
  return std::min(count, paritySizes().items);
}

std::vector<uint32_t> atMostItems(std::initializer_list<uint32_t> counts) {
  std::set<uint32_t> cut;
  for (const uint32_t count : counts) cut.insert(uint32_t(atMostItems(count)));
  return {cut.begin(), cut.end()};
}

GridShape atMostItems(GridShape shape) {
  while (shape.cells() > paritySizes().items) {
    uint32_t* shortest = nullptr;
    for (uint32_t* axis : {&shape.columns, &shape.rows, &shape.slabs}) {
      if (*axis > 1 && (!shortest || *axis < *shortest)) shortest = axis;
    }
    if (!shortest) break;
    *shortest /= 2;
  }
  return shape;
}

}  // namespace gw::test
