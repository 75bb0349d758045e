// bench/tick: milliseconds per tick on the cpu device, by scene and number of enemies.
//
//   uniform  about 20 neighbours within vision everywhere; 70 % of the enemies attack, 30 % wander
//   swarm    every enemy has attacked an untouchable ship for 20 s: the density that contact response allows
//
//   build/release/gw_bench_tick [--out FILE.md] [--threads N] [--enemies N,N,...] [--rounds R]
//
// Each figure is the median over rounds; a round restores the scene and times 30 ticks.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "game/sim/master.h"
#include "game/sim/simulation.h"
#include "game/tables/tables.h"

namespace {

using namespace gw;
using Clock = std::chrono::steady_clock;

constexpr uint32_t kTicksPerRound = 30, kSwarmTicks = 1200;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// The game's own rules, but: the first type always sees the ship, the others never do; nothing else spawns,
// nothing ends the run.
SimulationConfig configFor(uint32_t enemies, uint32_t threads, bool swarm) {
  SimulationConfig config;
  config.rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
  config.enemies = enemies;
  config.threads = threads;
  config.particles = true;  // as in a window; they are a stage of their own in the table
  Rules& rules = config.rules;
  rules.waveCount = 0;
  rules.endless.from_ticks = ~0u;
  rules.idle.fewerThan = 0;
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) {
    rules.enemies[t].sight_m = t == 0 || swarm ? 1.0e6f : 0.0f;
    rules.enemies[t].contact_us = 0;
  }
  return config;
}

// Enemies at 0.395 per square metre, which puts 20 within 4 m, around the middle of the world.
Snapshot uniformScene(Simulation& sim, const SimulationConfig& config) {
  Snapshot scene = sim.snapshot();
  Master master;
  std::memcpy(&master, scene.master.data(), sizeof master);
  master.tick = 1000;
  master.ship.untouchable_ticks = 1u << 30;
  std::memcpy(scene.master.data(), &master, sizeof master);

  const double area = config.enemies / 0.395, shape = sim.worldWidth_m() / sim.worldHeight_m();
  const double height = std::min<double>(sim.worldHeight_m() - 4.0, std::sqrt(area / shape));
  const double width = std::min<double>(sim.worldWidth_m() - 4.0, area / height);
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (uint32_t id = 0; id < config.enemies; ++id) {
    EntityRecord e{};
    e.id = id;
    e.type = unit(random) < 0.7 ? 0u : 1u + uint32_t(random() % (config.rules.enemyTypeCount - 1));
    const EnemyRules& rules = config.rules.enemies[e.type];
    e.x = e.previous_x = float(0.5 * sim.worldWidth_m() + (unit(random) - 0.5) * width);
    e.y = e.previous_y = float(0.5 * sim.worldHeight_m() + (unit(random) - 0.5) * height);
    const double angle = unit(random) * 6.283185307;
    e.direction_x = float(std::cos(angle));
    e.direction_y = float(std::sin(angle));
    e.velocity_x = e.direction_x * rules.speed_mps * 0.6f;
    e.velocity_y = e.direction_y * rules.speed_mps * 0.6f;
    e.energy = rules.energy;
    e.mass = rules.mass;
    e.state = e.type == 0 ? 1u : 0u;
    e.target = kNobody;
    scene.entities.push_back(e);
  }
  return scene;
}

Snapshot swarmScene(Simulation& sim, const SimulationConfig& config) {
  sim.restore(uniformScene(sim, config));
  for (uint32_t t = 0; t < kSwarmTicks; ++t) {
    sim.tick({});
    sim.report();
  }
  return sim.snapshot();
}

struct Figures {
  double tick_ms = 0, gather_ms = 0, candidates = 0, stages_ms = 0;
  std::vector<StageTime> stages;
};

Figures measure(uint32_t enemies, uint32_t threads, bool swarm, uint32_t rounds) {
  const SimulationConfig config = configFor(enemies, threads, swarm);
  const auto sim = cpu::makeSimulation(config);
  const Snapshot scene = swarm ? swarmScene(*sim, config) : uniformScene(*sim, config);
  std::vector<double> ticks, gathers;
  Figures figures;
  for (uint32_t round = 0; round < rounds + 1; ++round) {
    sim->restore(scene);
    for (int warm = 0; warm < 3; ++warm) {  // the upkeep after a full rebuild is not what is measured
      sim->tick({});
      sim->report();
    }
    const bool staged = round == rounds;  // the last round is for the stages, timed one by one
    sim->enableStageTimes(staged);
    const auto begin = Clock::now();
    for (uint32_t t = 0; t < kTicksPerRound; ++t) {
      sim->tick({});
      sim->report();
    }
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count() / kTicksPerRound;
    if (!staged) ticks.push_back(ms);
    const auto gather = Clock::now();
    const CandidateCount count = sim->countCandidates();
    gathers.push_back(std::chrono::duration<double, std::milli>(Clock::now() - gather).count());
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
        << " ticks; `gw_bench_tick`. The tick is the whole game on the cpu device; the 4 m gather is not part of it\n"
           "(kamikazes need no neighbours to think) and is what one pass of every enemy over its vision costs.\n\n"
        << "| scene | enemies | ms per tick | 4 m gather, ms | candidates per enemy |";
  bool named = false;
  std::ostringstream rows;
  for (const bool swarm : {false, true}) {
    for (const uint32_t enemies : sizes) {
      const Figures f = measure(enemies, threads, swarm, rounds);
      if (!named) {
        for (const StageTime& stage : f.stages) table << " " << stage.name << " |";
        table << "\n|---|---|---|---|---|";
        for (size_t i = 0; i < f.stages.size(); ++i) table << "---|";
        table << "\n";
        named = true;
      }
      char line[160];
      std::snprintf(line, sizeof line, "| %s | %u | %.3f | %.3f | %.1f |", swarm ? "swarm" : "uniform", enemies,
                    f.tick_ms, f.gather_ms, f.candidates);
      rows << line;
      for (const StageTime& stage : f.stages) {
        std::snprintf(line, sizeof line, " %.3f |", stage.total_ms / double(stage.calls));
        rows << line;
      }
      rows << "\n";
      std::fprintf(stderr, "%s %u: %.3f ms\n", swarm ? "swarm" : "uniform", enemies, f.tick_ms);
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
