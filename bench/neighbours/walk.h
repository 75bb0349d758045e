// The walk of a crowd by every way to find neighbours, in turns: how far those who miss some end from where they
// should, and what a step costs.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/neighbours/crowd.h"

namespace gw::bench {

struct WalkError {
  uint32_t step;  // after which
  double mean_m;  // distance from where an exact walk has its agent
};

struct WalkRow {
  uint32_t dimensions, entities;
  std::string distribution, way;
  float radius_m;
  double step_ms, over_grid;      // medians
  std::vector<WalkError> errors;  // after 1, 10, 100 ... steps and the last
};

// Throws std::runtime_error when two exact ways walk to different places. CellT is Cell or Cell3. `only`: see
// isAsked().
template <class CellT>
void walk(uint32_t n, Distribution distribution, uint32_t steps, uint32_t threads, const std::vector<std::string>& only,
          std::vector<WalkRow>& rows);

void writeCsv(std::ostream& out, const std::vector<WalkRow>& rows);
void writeMarkdown(std::ostream& out, const std::vector<WalkRow>& rows, const std::string& heading);

}  // namespace gw::bench
