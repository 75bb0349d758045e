// Every way to find neighbours on the same moving crowds: upkeep, gathering, what is missed, memory.
//
//   build/release/gw_bench_neighbours --entities 8192,65536 --distribution swarm --motion 0.1 --out table.md --csv
//   all.csv
//
// One run: in each frame all ways are handed the same places and take turns, so that drift of the machine meets all
// alike. Figures are typical milliseconds that passed: see typical(). What is missed is counted against the first
// exact way; a run fails when two exact ways find different neighbours.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <numeric>

#include "bench/device_option.h"
#include "bench/fingerprint.h"
#include "bench/machine.h"
#include "bench/neighbours/contender.h"
#include "bench/neighbours/crowd.h"
#include "bench/neighbours/device_ways.h"
#include "bench/neighbours/outsiders.h"
#include "bench/neighbours/table.h"
#include "bench/neighbours/walk.h"
#include "bench/scenes.h"

namespace {

using namespace gw;
using namespace gw::bench;

struct Wanted {
  std::vector<uint32_t> entities{8192, 65536};
  std::vector<std::string> distributions{"uniform", "swarm"}, only;
  std::vector<float> motions{0.1f};
  std::vector<uint32_t> dimensions{2};
  uint32_t frames = 100, threads = 0, crowdSteps = 0;
  std::string device = "cpu";
  double seconds = 180.0;  // for the frames of one crowd
  std::string out, csv;
  bool hash = false;
};

template <class CellT>
struct Entrant {
  Way way;
  std::unique_ptr<Contender<CellT>> contender;
  double build_ms = 0.0;
  std::vector<double> maintain_ms{}, gather_ms{}, total_ms{};
  std::vector<double> misaligned{};  // shares of the entities, in the frames that were looked at
  uint64_t found = 0, missed = 0;
  Fingerprint fingerprint{};  // of the frames that were looked at
};

double mean(const std::vector<double>& values) {  // NaN of none
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// The median, over ten stretches of frames, of the mean of a stretch: a median of frames would leave out what is done
// in every third frame only.
double typical(const std::vector<double>& frames_ms) {
  const size_t stretches = std::min<size_t>(10, frames_ms.size());
  std::vector<double> means;
  for (size_t s = 0; s < stretches; ++s) {
    const auto begin = frames_ms.begin() + std::ptrdiff_t(s * frames_ms.size() / stretches);
    const auto end = frames_ms.begin() + std::ptrdiff_t((s + 1) * frames_ms.size() / stretches);
    means.push_back(std::accumulate(begin, end, 0.0) / double(end - begin));
  }
  return median(means);
}

// From a sample.
template <class CellT>
double expectedGather_s(Contender<CellT>& contender, uint32_t n) {
  constexpr uint32_t kEvery = 64;
  if (n < 16 * kEvery) return 0.0;  // never long
  return kEvery * 1e-3 * milliseconds([&] {
           contender.probe(kEvery);
           contender.synchronise();
         });
}

// The slowest ways are, only now and then.
bool isPlayed(const Way& way, uint32_t frame) {
  return way.most == kAny || frame % 10 == 0;
}

template <class CellT>
void playFrame(Entrant<CellT>& e, const std::vector<CellT>& byId) {
  e.contender->move(byId);
  const double maintain = milliseconds([&] {
    e.contender->maintain();
    e.contender->synchronise();
  });
  const double gather = milliseconds([&] {
    e.contender->gather();
    e.contender->synchronise();
  });
  e.maintain_ms.push_back(maintain);
  e.gather_ms.push_back(gather);
  e.total_ms.push_back(maintain + gather);
}

// Adds what was found and missed in the last frame. Throws when an exact way found something else.
template <class CellT>
void compare(Entrant<CellT>& e, const std::vector<uint32_t>& truth) {
  const std::vector<uint32_t> counts = e.contender->counts();
  e.fingerprint.add(counts);
  for (size_t id = 0; id < truth.size(); ++id) {
    e.found += counts[id] - 1;
    e.missed += truth[id] - counts[id];
    if (counts[id] > truth[id] || (e.way.exact && counts[id] != truth[id])) {
      throw std::runtime_error(std::string(e.way.name) + " found " + std::to_string(counts[id]) + " instead of " +
                               std::to_string(truth[id]) + " for entity " + std::to_string(id));
    }
  }
}

template <class CellT>
void run(const Wanted& wanted, uint32_t dimensions, uint32_t n, Distribution distribution, float motion,
         std::vector<Row>& rows) {
  Crowd<CellT> crowd(n, distribution, 1);
  const Place place{{crowd.world[0], crowd.world[1], crowd.world[2]}, crowd.radius};
  const bool onCuda = takesCuda(wanted.device);
  std::vector<Way> ways = waysOf<CellT>(onCuda);
  const size_t own = ways.size();
  if (!onCuda) {  // they are host code
    for (const Way& way : outsiders()) ways.push_back(way);
  }
  std::vector<Entrant<CellT>> entrants;
  std::string leftOut;
  for (size_t w = 0; w < ways.size(); ++w) {
    if (n > ways[w].most || (w > 0 && !isAsked(ways[w], wanted.only)))
      continue;  // the first is what the others are compared with
    const ExecOptions options{wanted.threads};
    Entrant<CellT> e{ways[w], w < own ? make(static_cast<CellT*>(nullptr), onCuda, w, options, place, n)
                                      : makeOutsider<CellT>(w - own, options, place, n)};
    e.build_ms = milliseconds([&] { e.contender->start(crowd.byId); });
    const double frame_s = w > 0 ? expectedGather_s(*e.contender, n) : 0.0;
    if (frame_s > wanted.seconds / 10.0) {
      std::fprintf(stderr, "%uD %u %s %g %s: left out, a frame would take about %.0f s\n", dimensions, n,
                   kDistributions[int(distribution)], double(motion), e.way.name, frame_s);
      leftOut += (leftOut.empty() ? "Left out: " : ", ") + std::string(e.way.name) + " (a frame would take about " +
                 std::to_string(int(frame_s)) + " s)";
      continue;
    }
    entrants.push_back(std::move(e));
  }
  const uint32_t frames = std::max(3u, std::min(wanted.frames, uint32_t(100.0 * 65536.0 / double(n))));
  double passed_ms = 0.0;
  bool last = false;
  for (uint32_t frame = 0; !last; ++frame) {
    crowd.step(motion);
    passed_ms += milliseconds([&] {
      // Another goes first in each frame: the first finds the workers asleep.
      for (size_t turn = 0; turn < entrants.size(); ++turn) {
        Entrant<CellT>& e = entrants[(frame + turn) % entrants.size()];
        if (isPlayed(e.way, frame)) playFrame(e, crowd.byId);
      }
    });
    last = frame + 1 == frames || (frame + 1 >= 3 && !wanted.hash && passed_ms > wanted.seconds * 1000.0);
    if (frame % 10 != 0 && !last) continue;
    const std::vector<uint32_t> truth = entrants[0].contender->counts();
    for (Entrant<CellT>& e : entrants) {
      if (!isPlayed(e.way, frame)) continue;
      compare(e, truth);
      if (wanted.hash) e.fingerprint.add(e.contender->identities());
      if (const auto misaligned = e.contender->misaligned()) e.misaligned.push_back(*misaligned / double(n));
    }
  }
  const double best = typical(entrants[0].total_ms);
  for (Entrant<CellT>& e : entrants) {
    rows.push_back({.dimensions = dimensions,
                    .entities = n,
                    .distribution = kDistributions[int(distribution)],
                    .motion = motion,
                    .way = e.way.name,
                    .exact = e.way.exact,
                    .neighbours = crowd.neighbours,
                    .build_ms = e.build_ms,
                    .maintain_ms = typical(e.maintain_ms),
                    .gather_ms = typical(e.gather_ms),
                    .total = typical(e.total_ms),
                    .best = best,
                    .candidates = double(e.contender->candidates()) / double(n),
                    .recall = e.found + e.missed ? double(e.found) / double(e.found + e.missed) : 1.0,
                    .missed = e.missed,
                    .bytes = e.contender->bytes(),
                    .misalignedMean = mean(e.misaligned),
                    .misalignedLast = e.misaligned.empty() ? NAN : e.misaligned.back(),
                    .hash = e.fingerprint.value(),
                    .note = {}});
    std::fprintf(stderr, "%uD %u %s %g %s: %.3f ms, %.2f of the grid's\n", dimensions, n,
                 kDistributions[int(distribution)], double(motion), e.way.name, rows.back().total,
                 rows.back().total / best);
  }
  rows.back().note = leftOut;
}

Distribution named(const std::string& name) {
  const auto found = std::find(std::begin(kDistributions), std::end(kDistributions), name);
  if (found == std::end(kDistributions)) throw std::runtime_error("There is no distribution '" + name + "'.");
  return Distribution(found - std::begin(kDistributions));
}

// Writes to the files asked for. Done after each crowd: what a long run has measured is not lost when it ends early.
template <class AnyRow>
void save(const Wanted& wanted, const std::vector<AnyRow>& rows, const std::string& heading) {
  const auto write = [&](const std::string& path, const auto& content) {
    if (path.empty()) return;
    std::ofstream file(path);
    content(file);
    if (!file.flush()) throw std::runtime_error("Could not write " + path + "; name a folder that can be written.");
  };
  write(wanted.out, [&](std::ostream& file) { writeMarkdown(file, rows, heading); });
  write(wanted.csv, [&](std::ostream& file) { writeCsv(file, rows); });
}

std::string headingOf(const Wanted& wanted, const std::string& title, const std::string& what) {
  return "# " + title + "\n\n" + machineLine() + "\n\n" + what + "; " +
         (wanted.device == "cpu" ? std::to_string(wanted.threads) + " threads (0: all)" : "the cuda device") +
         "; `gw_bench_neighbours`.\n";
}

void measure(const Wanted& wanted) {
  const std::string heading =
      headingOf(wanted, "Neighbours", "At most " + std::to_string(wanted.frames) + " frames; medians");
  std::vector<Row> rows;
  for (const uint32_t d : wanted.dimensions) {
    for (const uint32_t n : wanted.entities) {
      for (const std::string& name : wanted.distributions) {
        for (const float motion : wanted.motions) {
          const auto runOne = d == 3 ? run<Cell3> : run<Cell>;
          runOne(wanted, d, n, named(name), motion, rows);
          save(wanted, rows, heading);
        }
      }
    }
  }
  writeMarkdown(std::cout, rows, heading);
  if (!wanted.hash) return;
  for (const Row& row : rows) {
    char what[160];
    std::snprintf(what, sizeof what, "%uD %u %s %g %s", row.dimensions, row.entities, row.distribution.c_str(),
                  double(row.motion), row.way.c_str());
    std::cout << hashLine(what, row.hash);
  }
}

void walkAll(const Wanted& wanted) {
  const std::string heading = headingOf(
      wanted, "A crowd that walks",
      std::to_string(wanted.crowdSteps) + " steps, all ways in turns; medians; mean distance from the exact walk");
  std::vector<WalkRow> rows;
  for (const uint32_t d : wanted.dimensions) {
    for (const uint32_t n : wanted.entities) {
      for (const std::string& name : wanted.distributions) {
        const auto walkOne = d == 3 ? walk<Cell3> : walk<Cell>;
        walkOne(n, named(name), wanted.crowdSteps, wanted.threads, wanted.only, rows);
        save(wanted, rows, heading);
      }
    }
  }
  writeMarkdown(std::cout, rows, heading);
}

}  // namespace

int main(int argc, char** argv) {
  Wanted wanted;
  CLI::App app{"Measures every way to find neighbours on the same moving crowds."};
  app.add_option("--entities", wanted.entities)->delimiter(',')->check(CLI::Range(3, 1 << 22));
  app.add_option("--distribution", wanted.distributions)->delimiter(',');
  app.add_option("--motion", wanted.motions, "radii per frame")->delimiter(',')->check(CLI::Range(0.0, 10.0));
  app.add_option("--dimensions", wanted.dimensions)->delimiter(',')->check(CLI::Range(2, 3));
  app.add_option("--only", wanted.only, "ways whose names hold one of these")->delimiter(';');
  app.add_option("--seconds", wanted.seconds,
                 "for one crowd: fewer frames, but at least 3, when they take longer; ways that take a tenth of it "
                 "for a frame are left out")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--frames", wanted.frames)->check(CLI::Range(3, 100000));
  addDeviceOption(app, wanted.device);
  app.add_option("--threads", wanted.threads)->check(CLI::Range(0, 256));
  app.add_option("--crowd-steps", wanted.crowdSteps, "instead: walk a crowd so many steps by every way, compare places")
      ->check(CLI::Range(0, 1000000));
  app.add_flag("--hash", wanted.hash,
               "also print a hash of what each way found in every tenth frame; all frames are played then");
  app.add_option("--out", wanted.out);
  app.add_option("--csv", wanted.csv);
  CLI11_PARSE(app, argc, argv);
  try {
    if (wanted.crowdSteps > 0 && wanted.device != "cpu") {
      throw std::runtime_error("--crowd-steps walks on the cpu device only; leave out one of the two.");
    }
    wanted.crowdSteps > 0 ? walkAll(wanted) : measure(wanted);
    printKernelsRun();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
