// Whole games on both devices: the same hash after every tick and the same snapshot at the end, with either
// broad phase and any block size on cuda.
#include <cstring>
#include <optional>
#include <stdexcept>

#include "game/sim/simulation.h"
#include "game/tables/tables.h"
#include "tests/gpu/parity_fixture.h"
#include "tests/gpu/parity_sizes.h"

namespace gw::test {
namespace {

SimulationConfig configOf(Mode mode) {
  SimulationConfig config;
  config.rules = loadRules(readRuleTexts(assetFolder()));
  config.seed = 0xC0FFEE;
  config.mode = mode;
  config.enemies = paritySizes().enemies;
  config.autopilot = Autopilot::expert;
  config.particles = true;  // for looks only, but from the same kernels
  return config;
}

std::unique_ptr<Simulation> makeOnCuda([[maybe_unused]] const SimulationConfig& config) {
#ifdef GW_HAVE_CUDA
  return cuda::makeSimulation(config);
#else
  throw std::logic_error("This build has no cuda device.");  // the fixture has skipped the test before
#endif
}

struct Game {
  std::vector<uint64_t> hashes;
  std::vector<InputRecord> inputs;
  Snapshot end;
  std::vector<Particle> particles;
};

// What the games begin with; nothing: with their first tick.
std::optional<Snapshot> beginning(const SimulationConfig& config) {
  if (paritySizes().firstTick == 0) return std::nullopt;
  const auto simulation = cpu::makeSimulation(config);
  for (uint32_t tick = 0; tick < paritySizes().firstTick; ++tick) {
    simulation->tick({});
    simulation->report();
  }
  return simulation->snapshot();
}

Game play(Simulation& simulation, const std::optional<Snapshot>& from = std::nullopt) {
  Game game;
  if (from) simulation.restore(*from);
  for (uint32_t tick = 0; tick < paritySizes().ticks; ++tick) {
    simulation.tick({});
    const TickReport report = simulation.report();
    game.hashes.push_back(report.hash);
    game.inputs.push_back(report.input);
  }
  game.end = simulation.snapshot();
  game.particles = simulation.particles();
  return game;
}

// The first thing in which two games differ; empty when they are the same.
std::string difference(const Game& expected, const Game& actual) {
  for (uint32_t tick = 0; tick < paritySizes().ticks; ++tick) {
    if (expected.inputs[tick] != actual.inputs[tick])
      return "the autopilot's input at tick " + std::to_string(tick + 1);
    if (expected.hashes[tick] != actual.hashes[tick]) return "the hash of tick " + std::to_string(tick + 1);
  }
  if (expected.end.globals != actual.end.globals) return "the globals in the snapshot";
  if (expected.end.entities.size() != actual.end.entities.size()) return "the number of entities in the snapshot";
  for (size_t i = 0; i < expected.end.entities.size(); ++i) {
    if (std::memcmp(&expected.end.entities[i], &actual.end.entities[i], sizeof(EntityRecord)) != 0) {
      return "entity " + std::to_string(expected.end.entities[i].id) + " in the snapshot";
    }
  }
  if (expected.particles.size() != actual.particles.size()) return "the number of particles";
  for (size_t i = 0; i < expected.particles.size(); ++i) {
    if (std::memcmp(&expected.particles[i], &actual.particles[i], sizeof(Particle)) != 0) {
      return "particle " + std::to_string(i);
    }
  }
  return "";
}

class GameParity : public ParityTest, public testing::WithParamInterface<Mode> {};

TEST_P(GameParity, EveryTickHasTheSameHash) {
  SimulationConfig config = configOf(GetParam());
  const std::optional<Snapshot> from = beginning(config);
  const Game expected = play(*cpu::makeSimulation(config), from);
  ASSERT_GT(expected.end.entities.size(), 10u) << "too little happened to compare";
  ASSERT_GT(expected.particles.size(), 10u) << "too little happened to compare";
  EXPECT_NE(expected.hashes.front(), expected.hashes.back());
  for (BroadPhase broadPhase : {BroadPhase::ngrid, BroadPhase::grid, BroadPhase::gridHashed, BroadPhase::bruteForce}) {
    for (uint32_t blockSize : paritySizes().blockSizes) {
      config.broadPhase = broadPhase;
      config.blockSize = blockSize;
      const Game actual = play(*makeOnCuda(config), from);
      EXPECT_EQ(difference(expected, actual), "")
          << "differs; broad phase " << uint32_t(broadPhase) << ", blocks of " << blockSize;
    }
  }
}

class SnapshotParity : public ParityTest {};

TEST_F(SnapshotParity, ContinuesOnTheOtherDevice) {
  const SimulationConfig config = configOf(Mode::arcade);
  const auto cpuGame = cpu::makeSimulation(config);
  const Game first = play(*cpuGame);
  const auto cudaGame = makeOnCuda(config);
  cudaGame->restore(first.end);
  Game onCpu = play(*cpuGame);
  const Game onCuda = play(*cudaGame);
  onCpu.particles = onCuda.particles;  // no snapshot holds them: the first half's flew on one device only
  EXPECT_EQ(difference(onCpu, onCuda), "") << "differs";
}

INSTANTIATE_TEST_SUITE_P(Modes, GameParity, testing::Values(Mode::arcade, Mode::swarm),
                         [](const auto& info) { return info.param == Mode::arcade ? "arcade" : "swarm"; });

}  // namespace
}  // namespace gw::test
