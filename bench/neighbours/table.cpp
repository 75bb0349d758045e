#include "bench/neighbours/table.h"

#include <cstdio>
#include <ostream>

namespace gw::bench {

void writeCsv(std::ostream& out, const std::vector<Row>& rows) {
  out << "dimensions,entities,distribution,motion_radii,way,neighbours,build_ms,maintain_ms,gather_ms,total_ms,"
         "total_over_grid,candidates,recall,missed_pairs,bytes\n";
  for (const Row& r : rows) {
    char line[400];
    std::snprintf(line, sizeof line, "%u,%u,%s,%g,\"%s\",%.2f,%.4f,%.4f,%.4f,%.4f,%.3f,%.2f,%.6f,%llu,%zu\n",
                  r.dimensions, r.entities, r.distribution.c_str(), double(r.motion), r.way.c_str(), r.neighbours,
                  r.build_ms, r.maintain_ms, r.gather_ms, r.total, r.total / r.best, r.candidates, r.recall,
                  static_cast<unsigned long long>(r.missed), r.bytes);
    out << line;
  }
}

void writeMarkdown(std::ostream& out, const std::vector<Row>& rows, const std::string& heading) {
  out << heading;
  const Row* before = nullptr;
  for (const Row& r : rows) {
    const bool another = !before || before->dimensions != r.dimensions || before->entities != r.entities ||
                         before->distribution != r.distribution || before->motion != r.motion;
    before = &r;
    char line[400];
    if (another) {
      std::snprintf(line, sizeof line, "\n## %uD, %u entities, %s, %g radii a frame: %.1f neighbours\n\n", r.dimensions,
                    r.entities, r.distribution.c_str(), double(r.motion), r.neighbours);
      out << line
          << "| way | maintain + gather, ms | over grid | maintain, ms | gather, ms | candidates | recall | built, ms "
             "| "
             "memory, KB |\n|---|---|---|---|---|---|---|---|---|\n";
    }
    std::snprintf(line, sizeof line, "| %s | %.3f | %.2f | %.3f | %.3f | %.1f | %.4f | %.2f | %.1f |\n", r.way.c_str(),
                  r.total, r.total / r.best, r.maintain_ms, r.gather_ms, r.candidates, r.recall, r.build_ms,
                  double(r.bytes) / 1024.0);
    out << line;
  }
}

}  // namespace gw::bench
