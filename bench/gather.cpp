// What every broad phase, gather and sort costs in the game, and what windows miss: 8,192 enemies, all ways in turn.
//
//   uniform  about 20 neighbours within vision everywhere; 70 % of the enemies attack, 30 % wander
//   swarm    every enemy has attacked an untouchable ship for 20 s of an exact game, then 5 s of its own
//
//   build/release/gw_bench_gather [--out FILE.md] [--threads N] [--enemies N] [--rounds R]
//
// Each way plays its own game. Recall and candidates are of the last tick: every enemy gathers within its vision
// where it stood, and an exact game that is given the same snapshot says how many neighbours there were. Times
// are of the processor, all threads together (one by default, since waiting workers spin), and medians over
// rounds; the ways take turns within a round, so that drift of the machine meets all alike.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

#include "bench/machine.h"
#include "bench/scenes.h"
#include "host/platform/clock.h"

namespace {

using namespace gw;
using namespace gw::bench;

constexpr uint32_t kTicksPerRound = 30, kOwnTicks = 300;

struct Way {
  const char* name;
  Gather gather;
  Sort sort;
  BroadPhase broadPhase = BroadPhase::ngrid;
};
constexpr Way kWays[] = {{"exact, bitonic", Gather::exact, Sort::bitonic},
                         {"exact, full", Gather::exact, Sort::full},
                         {"exact, frozen", Gather::exact, Sort::frozen},
                         {"uniform grid", Gather::exact, Sort::bitonic, BroadPhase::grid},
                         {"hashed grid", Gather::exact, Sort::bitonic, BroadPhase::gridHashed},
                         {"fixed 4, bitonic", Gather::fixed, Sort::bitonic},
                         {"fixed 4, odd-even", Gather::fixed, Sort::oddEven},
                         {"adaptive, bitonic", Gather::adaptive, Sort::bitonic},
                         {"adaptive, odd-even", Gather::adaptive, Sort::oddEven}};

template <class Work>
double processorMilliseconds(const Work& work) {
  const double begin_s = processTime_s();
  work();
  return 1e3 * (processTime_s() - begin_s);
}

struct Contender {
  SimulationConfig config;
  std::unique_ptr<Simulation> sim;
  Snapshot scene;
  std::vector<double> ticks_ms, gathers_ms;
};

// `start` is an exact game's: an inexact one arranges its cells afresh, then lives with what its upkeep makes of it.
Contender contend(SimulationConfig config, const Way& way, const Snapshot& start, bool swarm) {
  config.gather = way.gather;
  config.sort = way.sort;
  config.broadPhase = way.broadPhase;
  Contender c{config, cpu::makeSimulation(config), start, {}, {}};
  if (swarm) {
    c.sim->restore(start);
    playOn(*c.sim, kOwnTicks);
    c.scene = c.sim->snapshot();
  }
  return c;
}

void playRound(Contender& c) {
  c.sim->restore(c.scene);
  playOn(*c.sim, 3);  // the upkeep after a start is not what is measured
  c.ticks_ms.push_back(processorMilliseconds([&] { playOn(*c.sim, kTicksPerRound); }) / kTicksPerRound);
  c.gathers_ms.push_back(processorMilliseconds([&] { c.sim->countCandidates(); }));
}

double shareFound(const Contender& c, CandidateCount count) {
  SimulationConfig exact = c.config;
  exact.gather = Gather::exact;
  exact.sort = Sort::bitonic;
  exact.broadPhase = BroadPhase::ngrid;
  const auto oracle = cpu::makeSimulation(exact);
  oracle->restore(c.sim->snapshot());
  return double(count.found) / double(oracle->countCandidates().found);
}

void addRows(std::ostringstream& rows, const SimulationConfig& config, bool swarm, uint32_t rounds) {
  std::vector<Contender> contenders;
  const auto exact = cpu::makeSimulation(config);
  const Snapshot start = swarm ? swarmScene(*exact, config) : uniformScene(*exact, config);
  for (const Way& way : kWays) contenders.push_back(contend(config, way, start, swarm));
  for (uint32_t round = 0; round < rounds; ++round) {
    for (Contender& c : contenders) playRound(c);
  }
  const double exact_ms = median(contenders[0].ticks_ms), exactGather_ms = median(contenders[0].gathers_ms);
  for (size_t w = 0; w < contenders.size(); ++w) {
    Contender& c = contenders[w];
    const CandidateCount count = c.sim->countCandidates();
    const double tick_ms = median(c.ticks_ms), gather_ms = median(c.gathers_ms), each = double(count.entities);
    char line[200];
    std::snprintf(line, sizeof line, "| %s | %s | %.3f | %.1f | %.1f | %.2f | %.2f | %.3f | %.3f |\n",
                  swarm ? "swarm" : "uniform", kWays[w].name, shareFound(c, count), double(count.found) / each,
                  double(count.tested) / each, tick_ms / exact_ms, gather_ms / exactGather_ms, tick_ms, gather_ms);
    rows << line;
    std::fprintf(stderr, "%s", line);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string out;
  uint32_t threads = 1, rounds = 15, enemies = 8192;
  for (int i = 1; i + 1 < argc; i += 2) {
    const auto number = [&] { return uint32_t(std::max(1, std::atoi(argv[i + 1]))); };
    if (!std::strcmp(argv[i], "--out")) out = argv[i + 1];
    if (!std::strcmp(argv[i], "--threads")) threads = number();
    if (!std::strcmp(argv[i], "--rounds")) rounds = number();
    if (!std::strcmp(argv[i], "--enemies")) enemies = number();
  }
  std::ostringstream table;
  table << "# Gathers\n\n"
        << machineLine() << "\n\n"
        << enemies << " enemies; medians of " << rounds << " rounds of " << kTicksPerRound
        << " ticks, processor time; `gw_bench_gather`. A gather is one pass of every enemy over its vision.\n\n"
        << "| scene | gather, sort | recall | found per enemy | candidates per enemy | tick / exact | gather / exact "
           "| ms per tick | ms per gather |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const bool swarm : {false, true})
    addRows(table, configFor(enemies, threads, swarm ? Scene::swarm : Scene::uniform), swarm, rounds);
  std::fputs(table.str().c_str(), stdout);
  if (!out.empty() && !(std::ofstream(out) << table.str())) {
    std::fprintf(stderr, "Could not write %s; name a folder that exists and can be written.\n", out.c_str());
    return 1;
  }
  return 0;
}
