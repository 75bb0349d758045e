#include "bench/neighbours/table.h"

#include <cmath>
#include <cstdio>
#include <ostream>

#include "bench/neighbours/goals.h"

namespace gw::bench {
namespace {

std::string csvNumber(double value) {  // empty when there is none
  if (std::isnan(value)) return {};
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string percent(double share) {
  if (std::isnan(share)) return "-";
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", 100.0 * share);
  return text;
}

}  // namespace

void writeCsv(std::ostream& out, const std::vector<Row>& rows) {
  out << "dimensions,entities,distribution,motion_radii,way,neighbours,build_ms,maintain_ms,gather_ms,total_ms,"
         "total_over_grid,candidates,recall,missed_pairs,bytes,misaligned_mean,misaligned_last\n";
  for (const Row& r : rows) {
    char line[400];
    std::snprintf(line, sizeof line, "%u,%u,%s,%g,\"%s\",%.2f,%.4f,%.4f,%.4f,%.4f,%.3f,%.2f,%.6f,%llu,%zu,",
                  r.dimensions, r.entities, r.distribution.c_str(), double(r.motion), r.way.c_str(), r.neighbours,
                  r.build_ms, r.maintain_ms, r.gather_ms, r.total, r.total / r.best, r.candidates, r.recall,
                  static_cast<unsigned long long>(r.missed), r.bytes);
    out << line << csvNumber(r.misalignedMean) << ',' << csvNumber(r.misalignedLast) << '\n';
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
          << "| way | maintain + gather, ms | over grid | maintain, ms | gather, ms | candidates | recall | missed "
             "pairs "
             "| misaligned, %: mean | last | built, ms | memory, KB "
             "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    }
    std::snprintf(line, sizeof line,
                  "| %s | %.3f | %.2f | %.3f | %.3f | %.1f | %.4f | %llu | %s | %s | %.2f | %.1f |\n", r.way.c_str(),
                  r.total, r.total / r.best, r.maintain_ms, r.gather_ms, r.candidates, r.recall,
                  static_cast<unsigned long long>(r.missed), percent(r.misalignedMean).c_str(),
                  percent(r.misalignedLast).c_str(), r.build_ms, double(r.bytes) / 1024.0);
    out << line;
    if (!r.note.empty()) out << '\n' << r.note << ".\n";
  }
  writeGoals(out, rows);
}

}  // namespace gw::bench
