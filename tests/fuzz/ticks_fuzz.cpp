// The whole way of a replay: read, its tables taken, and 64 ticks played on the cpu device. A game with an exact gather
// is played once more by brute force, in another order: whatever the tables say, the hashes are the same.
#include <algorithm>
#include <memory>

#include "game/replay/replay_reader.h"
#include "game/sim/simulation.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/sealed_replay.h"

namespace gw::fuzz {
namespace {

constexpr uint32_t kMostTicks = 64;
constexpr uint32_t kMostEnemies = 256;  // beside 5,120 shots and bits: a tick stays short under the sanitisers

void play(const Replay& replay, SimulationConfig config) {
  config.enemies = std::min(config.enemies, kMostEnemies);
  config.threads = 1;
  const std::unique_ptr<Simulation> simulation = cpu::makeSimulation(config);
  std::unique_ptr<Simulation> other;
  if (config.gather == Gather::exact) {
    config.broadPhase = BroadPhase::bruteForce;
    config.order = VisitOrder::reversed;
    other = cpu::makeSimulation(config);
  }
  const uint32_t ticks = std::min(replay.ticks(), kMostTicks);
  for (uint32_t tick = 0; tick < ticks; ++tick) {
    simulation->tick(replay.inputs[tick]);
    const TickReport report = simulation->report();
    demand(report.tick <= tick + 1, "more ticks were played than asked for");
    demand(report.enemies <= config.enemies, "more enemies live than fit");
    if (!other) continue;
    other->tick(replay.inputs[tick]);
    demand(other->report().hash == report.hash, "brute force plays another game");
  }
}

}  // namespace
}  // namespace gw::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  try {
    const Replay replay = decodeReplay(fuzz::sealed({data, size}), "fuzz.gwr", SimulationVersions::any);
    fuzz::play(replay, replayConfig(replay));
  } catch (const ReplayError& error) {
    fuzz::demandSentence(error.what());
  } catch (const TableError& error) {
    fuzz::demandSentence(error.what());
  }
  return 0;
}
