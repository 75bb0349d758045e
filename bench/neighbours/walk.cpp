#include "bench/neighbours/walk.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <type_traits>

#include "bench/neighbours/walker.h"
#include "bench/scenes.h"

namespace gw::bench {
namespace {

// Brute force pays for every pair in every step.
constexpr uint32_t kMostOfSlow = kSlow / 8;

std::unique_ptr<Walker<Cell>> make(size_t way, const ExecOptions& o, const Place& p, uint32_t n, const WalkRule& r,
                                   const Cell*) {
  return cpu::makeWalker2(way, o, p, n, r);
}
std::unique_ptr<Walker<Cell3>> make(size_t way, const ExecOptions& o, const Place& p, uint32_t n, const WalkRule& r,
                                    const Cell3*) {
  return cpu::makeWalker3(way, o, p, n, r);
}

template <class CellT>
constexpr bool kDeep = std::is_same_v<CellT, Cell3>;

template <class CellT>
double meanDistance(const std::vector<CellT>& a, const std::vector<CellT>& b) {
  double sum = 0.0;
  for (size_t id = 0; id < a.size(); ++id) {
    const double x = double(a[id].x) - b[id].x, y = double(a[id].y) - b[id].y;
    double z = 0.0;
    if constexpr (kDeep<CellT>) z = double(a[id].z) - b[id].z;
    sum += std::sqrt(x * x + y * y + z * z);
  }
  return sum / double(a.size());
}

template <class CellT>
struct Party {
  Way way;
  std::unique_ptr<Walker<CellT>> walker;
  std::vector<double> step_ms{};
  std::vector<WalkError> errors{};
};

// Powers of ten, and the last.
bool isLookedAt(uint32_t step, uint32_t steps) {
  uint32_t power = 1;
  while (power < step) power *= 10;
  return power == step || step == steps;
}

template <class CellT>
void compareAll(std::vector<Party<CellT>>& parties, uint32_t step) {
  const std::vector<CellT> truth = parties[0].walker->places();
  for (Party<CellT>& party : parties) {
    const std::vector<CellT> places = party.walker->places();
    party.errors.push_back({step, meanDistance(places, truth)});
    if (party.way.exact && std::memcmp(places.data(), truth.data(), truth.size() * sizeof(CellT)) != 0) {
      throw std::runtime_error(std::string(party.way.name) + " walked elsewhere than " + parties[0].way.name +
                               " after " + std::to_string(step) + " steps, though both are exact");
    }
  }
}

}  // namespace

template <class CellT>
void walk(uint32_t n, Distribution distribution, uint32_t steps, uint32_t threads, const std::vector<std::string>& only,
          std::vector<WalkRow>& rows) {
  const Crowd<CellT> crowd(n, distribution, 1);
  const float r = crowd.radius;
  const Place place{{crowd.world[0], crowd.world[1], crowd.world[2]}, r};
  // In radii, so that crowds of any density walk alike; 1.4 m/s where the radius is 4 m.
  const WalkRule rule{r, 0.1f, 0.35f * r, 0.5f, 0.7f * r};
  std::vector<CellT> goals = crowd.byId;  // on the other side, so that two streams meet
  for (CellT& goal : goals) goal.x = crowd.world[0] - goal.x;

  std::vector<Party<CellT>> parties;
  const std::vector<Way> ways = kDeep<CellT> ? cpu::ways3() : cpu::ways2();
  const auto join = [&](const Way& way, size_t number, const std::vector<CellT>& from) {
    parties.push_back({way, make(number, ExecOptions{threads}, place, n, rule, static_cast<CellT*>(nullptr))});
    parties.back().walker->start(from, goals);
  };
  for (size_t w = 0; w < ways.size(); ++w) {
    const bool tooSlow = ways[w].most < kAny && n > std::min(ways[w].most, kMostOfSlow);
    if (w == 0 || (isAsked(ways[w], only) && !tooSlow)) join(ways[w], w, crowd.byId);
  }
  // Whatever is different at first grows by itself. How much of an error that is shows the same exact walk, begun as
  // little aside as missed neighbours put a walker in the first steps.
  std::vector<CellT> aside = crowd.byId;
  for (CellT& cell : aside) cell.x += (cell.id % 2 == 0 ? 1e-3f : -1e-3f) * r;
  join({"(grid, begun 0.001 r aside)", false, kAny}, 0, aside);

  for (uint32_t step = 1; step <= steps; ++step) {
    for (size_t turn = 0; turn < parties.size(); ++turn) {
      Party<CellT>& party = parties[(step + turn) % parties.size()];
      party.step_ms.push_back(milliseconds([&] {
        party.walker->step();
        party.walker->synchronise();
      }));
    }
    if (isLookedAt(step, steps)) compareAll(parties, step);
  }
  const double grid_ms = median(parties[0].step_ms);
  for (Party<CellT>& party : parties) {
    const double step_ms = median(party.step_ms);
    rows.push_back({kDeep<CellT> ? 3u : 2u, n, kDistributions[int(distribution)], party.way.name, r, step_ms,
                    step_ms / grid_ms, party.errors});
    std::fprintf(stderr, "%uD %u %s %s: %.3f ms a step, %.4f m off at the end\n", rows.back().dimensions, n,
                 kDistributions[int(distribution)], party.way.name, step_ms, party.errors.back().mean_m);
  }
}

template void walk<Cell>(uint32_t, Distribution, uint32_t, uint32_t, const std::vector<std::string>&,
                         std::vector<WalkRow>&);
template void walk<Cell3>(uint32_t, Distribution, uint32_t, uint32_t, const std::vector<std::string>&,
                          std::vector<WalkRow>&);

void writeCsv(std::ostream& out, const std::vector<WalkRow>& rows) {
  out << "dimensions,entities,distribution,way,radius_m,step_ms,step_over_grid,step,mean_error_m,mean_error_radii\n";
  for (const WalkRow& r : rows) {
    for (const WalkError& error : r.errors) {
      char line[400];
      std::snprintf(line, sizeof line, "%u,%u,%s,\"%s\",%.4f,%.4f,%.3f,%u,%.6g,%.6g\n", r.dimensions, r.entities,
                    r.distribution.c_str(), r.way.c_str(), double(r.radius_m), r.step_ms, r.over_grid, error.step,
                    error.mean_m, error.mean_m / double(r.radius_m));
      out << line;
    }
  }
}

void writeMarkdown(std::ostream& out, const std::vector<WalkRow>& rows, const std::string& heading) {
  out << heading;
  const WalkRow* before = nullptr;
  for (const WalkRow& r : rows) {
    char text[400];
    if (!before || before->dimensions != r.dimensions || before->entities != r.entities ||
        before->distribution != r.distribution) {
      std::snprintf(text, sizeof text, "\n## %uD, %u walkers, %s: radius %.3f m\n\n| way | step, ms | over grid |",
                    r.dimensions, r.entities, r.distribution.c_str(), double(r.radius_m));
      out << text;
      for (const WalkError& error : r.errors) out << " error after " << error.step << ", m (radii) |";
      out << "\n|---|---|---|";
      for (size_t i = 0; i < r.errors.size(); ++i) out << "---|";
      out << '\n';
    }
    before = &r;
    std::snprintf(text, sizeof text, "| %s | %.3f | %.2f |", r.way.c_str(), r.step_ms, r.over_grid);
    out << text;
    for (const WalkError& error : r.errors) {
      std::snprintf(text, sizeof text, error.mean_m > 0.0 ? " %.2g (%.2g) |" : " 0 |", error.mean_m,
                    error.mean_m / double(r.radius_m));
      out << text;
    }
    out << '\n';
  }
}

}  // namespace gw::bench
