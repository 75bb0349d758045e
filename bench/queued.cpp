// bench/queued: microseconds per tick when the device is never kept waiting, per stage, and how fast bytes move.
//
//   build/release/gw_bench_queued [--device cpu|cuda] [--enemies N,N,...] [--scenes uniform,mixed] [--json FILE]
//
// bench/tick asks tick by tick, as a window does; here as many ticks are queued as a simulation takes before the
// oldest report is read. A figure is the median over rounds; stages are timed in a round of their own, by
// events inside the tick's graph, which make it a little longer.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/copies.h"
#include "bench/device_option.h"
#include "bench/machine.h"
#include "bench/scenes.h"

namespace {

using namespace gw;
using namespace gw::bench;

struct Wanted {
  std::string device = "cpu", json;
  std::filesystem::path assets;
  std::vector<uint32_t> enemies{1024, 8192, 65536};
  std::vector<std::string> scenes{"uniform", "mixed"};
  uint32_t ticks = 240, rounds = 5, copyMebibytes = 256;
};

std::unique_ptr<Simulation> makeOn([[maybe_unused]] bool onCuda, const SimulationConfig& config) {
#ifdef GW_HAVE_CUDA
  if (onCuda) return cuda::makeSimulation(config);
#endif
  return cpu::makeSimulation(config);
}

CopySpeeds copySpeedsOn([[maybe_unused]] bool onCuda, size_t bytes, unsigned rounds) {
#ifdef GW_HAVE_CUDA
  if (onCuda) return cuda::copySpeeds({}, bytes, rounds);
#endif
  return cpu::copySpeeds({}, bytes, rounds);
}

Scene sceneNamed(const std::string& name) {
  for (const Scene scene : {Scene::uniform, Scene::swarm, Scene::mixed, Scene::horde}) {
    if (name == nameOf(scene)) return scene;
  }
  throw std::runtime_error("There is no scene '" + name + "'; choose uniform, swarm, mixed or horde.");
}

void playQueued(Simulation& simulation, uint32_t ticks) {
  uint32_t queued = 0;
  for (uint32_t read = 0; read < ticks; ++read) {
    for (; queued < ticks && queued - read < Simulation::kTicksInFlight; ++queued) simulation.tick({});
    simulation.report();
  }
}

nlohmann::ordered_json measure(const Wanted& wanted, bool onCuda, Scene which, uint32_t enemies) {
  const SimulationConfig config = configFor(enemies, 0, which, wanted.assets);
  const auto simulation = makeOn(onCuda, config);
  const Snapshot scene = sceneOf(which, *simulation, config);
  std::vector<double> ticks_us;
  for (uint32_t round = 0; round < wanted.rounds; ++round) {
    simulation->restore(scene);
    playQueued(*simulation, 8);  // the full sort after a restored scene is not what is measured
    ticks_us.push_back(1e3 * milliseconds([&] { playQueued(*simulation, wanted.ticks); }) / wanted.ticks);
  }
  simulation->restore(scene);
  playQueued(*simulation, 8);
  simulation->enableStageTimes(true);
  playQueued(*simulation, wanted.ticks);

  nlohmann::ordered_json row;
  row["scene"] = nameOf(which);
  row["enemies"] = enemies;
  row["tick_us"] = median(ticks_us);
  row["launchesPerTick"] = simulation->launchesPerTick();
  for (const StageTime& stage : simulation->stageTimes()) {
    row["stages_us"][stage.name] = 1e3 * stage.total_ms / double(stage.calls);
  }
  return row;
}

void print(const nlohmann::ordered_json& row) {
  std::printf("%-8s %8u enemies: %10.2f us a tick;", row["scene"].get<std::string>().c_str(),
              row["enemies"].get<uint32_t>(), row["tick_us"].get<double>());
  for (const auto& [name, us] : row["stages_us"].items()) std::printf(" %s %.2f", name.c_str(), us.get<double>());
  std::printf("\n");
  std::fflush(stdout);  // a long run that is stopped has shown what it knew
}

void run(const Wanted& wanted) {
  const bool onCuda = takesCuda(wanted.device);
  nlohmann::ordered_json all;
  all["device"] = wanted.device;
  all["ticks"] = wanted.ticks;
  all["rounds"] = wanted.rounds;
  const CopySpeeds copies = copySpeedsOn(onCuda, size_t(wanted.copyMebibytes) << 20, 10);
  all["copies_GBps"] = {{"toDevice", copies.toDevice}, {"toHost", copies.toHost}, {"onDevice", copies.onDevice}};
  std::printf("%s\ncopies of %u MiB, GB/s: %.1f to the device, %.1f to the host, %.1f on the device\n",
              machineLine().c_str(), wanted.copyMebibytes, copies.toDevice, copies.toHost, copies.onDevice);
  for (const std::string& scene : wanted.scenes) {
    for (const uint32_t enemies : wanted.enemies) {
      all["rows"].push_back(measure(wanted, onCuda, sceneNamed(scene), enemies));
      print(all["rows"].back());
    }
  }
  printKernelsRun();
  if (!wanted.json.empty() && !(std::ofstream(wanted.json) << all.dump(2) << "\n")) {
    throw std::runtime_error("Could not write " + wanted.json + "; name a folder that exists and can be written.");
  }
}

}  // namespace

int main(int argc, char** argv) {
  Wanted wanted;
  CLI::App app{"Microseconds per tick with ticks queued, per stage, and copy speeds."};
  addDeviceOption(app, wanted.device);
  app.add_option("--enemies", wanted.enemies)->delimiter(',')->check(CLI::Range(1, 1 << 22));
  app.add_option("--scenes", wanted.scenes, "uniform, swarm, mixed, horde")->delimiter(',');
  app.add_option("--ticks", wanted.ticks, "in one round")->check(CLI::Range(1, 1000000));
  app.add_option("--rounds", wanted.rounds)->check(CLI::Range(1, 1000));
  app.add_option("--copy-mebibytes", wanted.copyMebibytes)->check(CLI::Range(1, 4096));
  app.add_option("--assets", wanted.assets, "folder of rule tables");
  app.add_option("--json", wanted.json);
  CLI11_PARSE(app, argc, argv);
  try {
    run(wanted);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
