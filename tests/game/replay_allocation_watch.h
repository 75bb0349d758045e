// Watches the sizes that this test program asks `new` for.
#pragma once

#include <cstddef>

namespace gw::test {

void watchAllocations();     // forget what was seen
size_t largestAllocation();  // bytes, since watchAllocations()

}  // namespace gw::test
