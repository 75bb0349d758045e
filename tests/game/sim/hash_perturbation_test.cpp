// Proof that comparing hashes can fail: one float moved by one unit in the last place, one bit of the globals,
// one missing shot: the game is another from the next tick on.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

class hash_perturbation : public ::testing::Test {
 protected:
  const SimulationConfig config = stageConfig();
  const Snapshot scene = [this] {
    const auto simulation = cpu::makeSimulation(config);
    simulation->restore(crowdScene(config, 100));
    play(*simulation, 20, std::vector<InputRecord>(20, {kStickFull, 0, 0, kButtonFire}));
    return simulation->snapshot();
  }();

  std::vector<uint64_t> run(const Snapshot& from) const {
    const auto simulation = cpu::makeSimulation(config);
    simulation->restore(from);
    return hashesOf(play(*simulation, 40));
  }
  void expectAnother(const Snapshot& changed) const {
    const auto before = run(scene), after = run(changed);
    for (size_t t = 0; t < before.size(); ++t) EXPECT_NE(before[t], after[t]) << "tick " << t;
  }
};

TEST_F(hash_perturbation, without_one_the_hashes_are_equal) {
  EXPECT_EQ(run(scene), run(scene));
}

TEST_F(hash_perturbation, a_place_by_one_ulp) {
  Snapshot changed = scene;
  changed.entities[40].x = std::nextafterf(changed.entities[40].x, 1.0e9f);
  expectAnother(changed);
}

TEST_F(hash_perturbation, an_energy_by_one_ulp) {
  Snapshot changed = scene;
  changed.entities[40].energy = std::nextafterf(changed.entities[40].energy, 0.0f);
  expectAnother(changed);
}

TEST_F(hash_perturbation, the_ship_by_one_ulp) {
  Snapshot changed = scene;
  GameGlobals globals = globalsOf(changed);
  globals.ship.x = std::nextafterf(globals.ship.x, 0.0f);
  std::memcpy(changed.globals.data(), &globals, sizeof globals);
  expectAnother(changed);
}

TEST_F(hash_perturbation, the_seed_by_one_bit) {
  Snapshot changed = scene;
  changed.globals[7] ^= 0x80;
  expectAnother(changed);
}

TEST_F(hash_perturbation, one_entity_missing) {
  Snapshot changed = scene;
  changed.entities.pop_back();
  expectAnother(changed);
}

}  // namespace
}  // namespace gw::test
