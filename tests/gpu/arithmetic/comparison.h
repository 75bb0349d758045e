// Compares the arithmetic of two devices, block by block.
#pragma once

#include <cstdint>
#include <string>

#include "tests/gpu/arithmetic/blocks.h"

namespace gw::test {

// A device, or what stands for one, by name.
struct Side {
  std::string name;
  Arithmetic arithmetic;
  uint64_t spoilt = kNotSpoilt;
};

struct Comparison {
  uint64_t inputs = 0;           // really compared
  uint64_t differingBlocks = 0;  // of kBlockInputs each
  std::string first;             // the first operation that differs: operands and both results; empty when none does
};

// Of at least so many inputs, in whole blocks.
Comparison compare(const Side& expected, const Side& actual, Operations operations, uint64_t inputs);

}  // namespace gw::test
