#include "bench/neighbours/goals.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace gw::bench {
namespace {

struct Goal {
  std::string what;
  uint32_t entities;
  std::string wanted;
  double measured;
  bool met;
};

// Of those that stand for the goals: in the plane, a swarm, a tenth of the radius per frame.
const Row* find(const std::vector<Row>& rows, uint32_t n, const std::string& way) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
    return r.dimensions == 2 && r.entities == n && r.distribution == "swarm" && r.motion == 0.1f && r.way == way;
  });
  return found == rows.end() ? nullptr : &*found;
}

const Row* fastestNGrid(const std::vector<Row>& rows, uint32_t n) {
  const Row* best = nullptr;
  for (const Row& r : rows) {
    const bool candidate = r.exact && r.way.starts_with("ngrid") && &r == find(rows, n, r.way);
    if (candidate && (!best || r.total < best->total)) best = &r;
  }
  return best;
}

void addSpeeds(std::vector<Goal>& goals, const std::vector<Row>& rows, uint32_t n) {
  const Row *ngrid = fastestNGrid(rows, n), *grid = find(rows, n, "grid");
  const auto atLeast = [&](const char* what, const Row* slow, const Row* fast, double times) {
    if (!slow || !fast) return;
    char wanted[40];
    std::snprintf(wanted, sizeof wanted, "at least %g", times);
    goals.push_back({what, n, wanted, slow->total / fast->total, slow->total >= times * fast->total});
  };
  if (ngrid && grid) {
    goals.push_back({"fastest exact NGrid (" + ngrid->way + ") over the best grid, times", n, "at most 1",
                     ngrid->total / grid->total, ngrid->total <= grid->total});
  }
  atLeast("the thesis's hashed grid over that NGrid, times", find(rows, n, "grid, hashed"), ngrid, 2.0);
  if (n == 65536) atLeast("brute force over that NGrid, times", find(rows, n, "brute force"), ngrid, 20.0);
  atLeast("k-d tree (nanoflann) over the best grid, times", find(rows, n, "k-d tree (nanoflann)"), grid, 10.0);
}

}  // namespace

void writeGoals(std::ostream& out, const std::vector<Row>& rows) {
  std::vector<Goal> goals;
  for (const uint32_t n : {8192u, 65536u}) {
    addSpeeds(goals, rows, n);
    double least = 1.0;
    for (const Row& r : rows) {
      if (r.exact && &r == find(rows, n, r.way)) least = std::min(least, r.recall);
    }
    if (find(rows, n, "grid")) goals.push_back({"recall, the least of all exact ways", n, "1", least, least == 1.0});
  }
  const auto million = std::find_if(rows.begin(), rows.end(), [](const Row& r) {
    return r.dimensions == 2 && r.entities == 1u << 20 && r.way == "ngrid, bitonic";
  });
  if (million != rows.end()) {
    const double kilobytes = double(million->bytes) / 1024.0;
    goals.push_back({"memory of the NGrid in place beyond the entities, with the cells that pad it, KB",
                     million->entities, "under 64", kilobytes, kilobytes < 64.0});
  }
  if (goals.empty()) return;
  out << "\n## Goals\n\nIn the plane; times of upkeep and gathering together, in a swarm that moves by 0.1 radii a "
         "frame.\n\n"
         "| what | entities | wanted | measured | |\n|---|---|---|---|---|\n";
  for (const Goal& goal : goals) {
    char line[300];
    std::snprintf(line, sizeof line, "| %s | %u | %s | %.2f | %s |\n", goal.what.c_str(), goal.entities,
                  goal.wanted.c_str(), goal.measured, goal.met ? "met" : "**missed**");
    out << line;
  }
}

}  // namespace gw::bench
