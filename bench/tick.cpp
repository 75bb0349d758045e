// bench/tick: milliseconds per tick on the cpu device, by scene and number of enemies.
//
//   uniform  kamikazes, about 20 neighbours within vision everywhere; 70 % of them attack, 30 % wander
//   swarm    the same, all of which have attacked an untouchable ship for 20 s: the density contact response allows
//   mixed    all seven types in the arcade's mix, all over the world, as they live after 5 s
//   horde    the same, all of which have attacked for 20 s
//
//   build/release/gw_bench_tick [--out FILE.md] [--threads N] [--enemies N,N,...] [--rounds R]
//
// Each figure is the median over rounds; a round restores the scene and times 30 ticks.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/scenes.h"

namespace {

using namespace gw;
using namespace gw::bench;

constexpr uint32_t kTicksPerRound = 30;

struct Figures {
  double tick_ms = 0, gather_ms = 0, candidates = 0, stages_ms = 0;
  std::vector<StageTime> stages;
};

Figures measure(uint32_t enemies, uint32_t threads, Scene which, uint32_t rounds) {
  SimulationConfig config = configFor(enemies, threads, which);
  config.particles = true;  // as in a window; they are a stage of their own in the table
  const auto sim = cpu::makeSimulation(config);
  const Snapshot scene = sceneOf(which, *sim, config);
  std::vector<double> ticks, gathers;
  Figures figures;
  for (uint32_t round = 0; round < rounds + 1; ++round) {
    sim->restore(scene);
    playOn(*sim, 3);                      // the upkeep after a full rebuild is not what is measured
    const bool staged = round == rounds;  // the last round is for the stages, timed one by one
    sim->enableStageTimes(staged);
    const double ms = milliseconds([&] { playOn(*sim, kTicksPerRound); }) / kTicksPerRound;
    if (!staged) ticks.push_back(ms);
    CandidateCount count;
    gathers.push_back(milliseconds([&] { count = sim->countCandidates(); }));
    figures.candidates = count.entities ? double(count.tested) / double(count.entities) : 0.0;
  }
  figures.tick_ms = median(ticks);
  figures.gather_ms = median(gathers);
  figures.stages = sim->stageTimes();
  return figures;
}

}  // namespace

int main(int argc, char** argv) {
  std::string out;
  uint32_t threads = 0, rounds = 15;
  std::vector<uint32_t> sizes{1024, 8192, 65536};
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--out")) out = argv[i + 1];
    if (!std::strcmp(argv[i], "--threads")) threads = uint32_t(std::atoi(argv[i + 1]));
    if (!std::strcmp(argv[i], "--rounds")) rounds = uint32_t(std::max(1, std::atoi(argv[i + 1])));
    if (!std::strcmp(argv[i], "--enemies")) {
      sizes.clear();
      std::stringstream list(argv[i + 1]);
      for (std::string size; std::getline(list, size, ',');) sizes.push_back(uint32_t(std::stoul(size)));
    }
  }
  std::ostringstream table;
  table << "# Tick\n\n"
        << machineLine() << "\n\nMedians of " << rounds << " rounds of " << kTicksPerRound
        << " ticks; `gw_bench_tick`. The tick is the whole game on the cpu device; the 4 m gather is not part of it:\n"
           "it is what one pass of every enemy over its vision costs.\n\n"
        << "| scene | enemies | ms per tick | 4 m gather, ms | candidates per enemy |";
  bool named = false;
  std::ostringstream rows;
  for (const Scene scene : {Scene::uniform, Scene::swarm, Scene::mixed, Scene::horde}) {
    for (const uint32_t enemies : sizes) {
      const Figures f = measure(enemies, threads, scene, rounds);
      if (!named) {
        for (const StageTime& stage : f.stages) table << " " << stage.name << " |";
        table << "\n|---|---|---|---|---|";
        for (size_t i = 0; i < f.stages.size(); ++i) table << "---|";
        table << "\n";
        named = true;
      }
      char line[160];
      std::snprintf(line, sizeof line, "| %s | %u | %.3f | %.3f | %.1f |", nameOf(scene), enemies, f.tick_ms,
                    f.gather_ms, f.candidates);
      rows << line;
      for (const StageTime& stage : f.stages) {
        std::snprintf(line, sizeof line, " %.3f |", stage.total_ms / double(stage.calls));
        rows << line;
      }
      rows << "\n";
      std::fprintf(stderr, "%s %u: %.3f ms\n", nameOf(scene), enemies, f.tick_ms);
    }
  }
  const std::string text = table.str() + rows.str();
  std::fputs(text.c_str(), stdout);
  if (!out.empty() && !(std::ofstream(out) << text)) {
    std::fprintf(stderr, "Could not write %s; name a folder that exists and can be written.\n", out.c_str());
    return 1;
  }
  return 0;
}
