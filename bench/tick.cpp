// bench/tick: milliseconds per tick on the cpu device, by scene and number of enemies.
//
//   uniform  kamikazes, about 20 neighbours within vision everywhere; 70 % of them attack, 30 % wander
//   swarm    the same, all of which have attacked an untouchable ship for 20 s: the density contact response allows
//   mixed    all seven types in the arcade's mix, all over the world, as they live after 5 s
//   horde    the same, all of which have attacked for 20 s
//
//   build/release/gw_bench_tick [--out FILE.md] [--threads N] [--enemies N,N,...] [--rounds R] [--hash]
//
// Each figure is the median over rounds; a round restores the scene and times 30 ticks. --hash prints, for each scene
// and size, the fingerprint of the hashes of those ticks: the same in every build that plays the same game.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/fingerprint.h"
#include "bench/machine.h"
#include "bench/scenes.h"

namespace {

using namespace gw;
using namespace gw::bench;

constexpr uint32_t kTicksPerRound = 30;

struct Figures {
  double tick_ms = 0, gather_ms = 0, candidates = 0;
  uint64_t hash = 0;  // of a round's ticks
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
    uint64_t hash = 0;
    const double ms = milliseconds([&] { hash = playOn(*sim, kTicksPerRound); }) / kTicksPerRound;
    if (round == 0) figures.hash = hash;
    if (hash != figures.hash) {
      throw std::runtime_error("Round " + std::to_string(round) + " of " + nameOf(which) + " " +
                               std::to_string(enemies) + " played another game than the first: this is a fault.");
    }
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

int run(uint32_t threads, uint32_t rounds, const std::vector<uint32_t>& sizes, const std::string& out, bool hashes) {
  std::ostringstream table;
  table << "# Tick\n\n"
        << machineLine() << "\n\nMedians of " << rounds << " rounds of " << kTicksPerRound
        << " ticks; `gw_bench_tick`. The tick is the whole game on the cpu device; the 4 m gather is not part of it:\n"
           "it is what one pass of every enemy over its vision costs.\n\n"
        << "| scene | enemies | ms per tick | 4 m gather, ms | candidates per enemy |";
  bool named = false;
  std::ostringstream rows;
  std::string hashLines;
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
      hashLines += hashLine(std::string(nameOf(scene)) + " " + std::to_string(enemies), f.hash);
      std::fprintf(stderr, "%s %u: %.3f ms\n", nameOf(scene), enemies, f.tick_ms);
    }
  }
  const std::string text = table.str() + rows.str();
  std::fputs(text.c_str(), stdout);
  if (hashes) std::fputs(hashLines.c_str(), stdout);
  if (!out.empty() && !(std::ofstream(out) << text)) {
    std::fprintf(stderr, "Could not write %s; name a folder that exists and can be written.\n", out.c_str());
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string out;
  uint32_t threads = 0, rounds = 15;
  std::vector<uint32_t> sizes{1024, 8192, 65536};
  bool hashes = false;
  CLI::App app{"Measures the tick of the whole game on the cpu device, by scene and number of enemies."};
  app.add_option("--out", out, "also write the table to this file");
  app.add_option("--threads", threads, "0: all")->check(CLI::Range(0, 256));
  app.add_option("--enemies", sizes)->delimiter(',')->check(CLI::Range(1, 1000000));
  app.add_option("--rounds", rounds)->check(CLI::Range(1, 100000));
  app.add_flag("--hash", hashes, "also print a hash of what each scene computed");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(threads, rounds, sizes, out, hashes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
