// What is wanted of the NGrid, held against what the run measured.
#pragma once

#include <iosfwd>
#include <vector>

#include "bench/neighbours/table.h"

namespace gw::bench {

// Appends a section to the Markdown: each goal that the rows can speak of. Nothing when they speak of none.
void writeGoals(std::ostream& out, const std::vector<Row>& rows);

}  // namespace gw::bench
