// Watches what this test program asks `new` for.
#pragma once

#include <cstddef>

namespace gw::test {

void watchAllocations();     // forget what was seen
size_t largestAllocation();  // bytes, since watchAllocations()
size_t peakAllocated();      // bytes held at a time since then, beyond what was held then
size_t allocations();        // how many since then

}  // namespace gw::test
