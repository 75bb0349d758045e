// The judge of gathering methods: the set, the count and the places found against plain host code.
#pragma once

#include <string>

#include "tests/gpu/random_cells.h"

namespace gw::test {

// Empty when the method finds for each query exactly what the oracle finds; else the first query that is wrong.
std::string checkGather(GridShape shape, const std::vector<Cell>& cells, const std::vector<Query>& queries,
                        Method method, const ExecOptions& options = {1});

// The same in three dimensions.
std::string checkGather(GridShape shape, const std::vector<Cell3>& cells, const std::vector<Query3>& queries,
                        Method method, const ExecOptions& options = {1});

}  // namespace gw::test
