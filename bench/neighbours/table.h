// What the bench writes: every measured row as CSV, and a Markdown table for people.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace gw::bench {

struct Row {
  uint32_t dimensions, entities;
  std::string distribution;
  float motion;  // radii per frame
  std::string way;
  bool exact;
  double neighbours;  // others found per entity
  double build_ms, maintain_ms, gather_ms;
  double total, best;  // medians of maintain + gather: of this way, of the grid in the same run
  double candidates;   // pair tests per entity
  double recall;       // pairs found of those that brute force would find
  uint64_t missed;     // pairs, over all measured frames
  size_t bytes;        // beyond the entities
  // Shares of the entities that stood before their predecessor on a line after upkeep: in the frames that were looked
  // at on average, and in the last one. NaN where there are no lines.
  double misalignedMean, misalignedLast;
  uint64_t hash;     // of what it found, in the frames that were looked at
  std::string note;  // to be read below the row
};

void writeCsv(std::ostream& out, const std::vector<Row>& rows);
void writeMarkdown(std::ostream& out, const std::vector<Row>& rows, const std::string& heading);

}  // namespace gw::bench
