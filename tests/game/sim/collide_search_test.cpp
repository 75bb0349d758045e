// Proof that the comparisons of collide_test can fail: with a broken search the stage differs from the naive
// version, and without the breakage it does not.
#include <gtest/gtest.h>

#include "tests/game/sim/broken_collide.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

// In how many of ten crowds the stage differs from the naive version.
uint32_t differences(BroadPhase broadPhase, cpu::Break how) {
  SimulationConfig config = stageConfig();
  config.broadPhase = broadPhase;
  StageFixture fixture(config);
  uint32_t differ = 0;
  for (uint32_t seed = 0; seed < 10; ++seed) {
    naive::World world = fixture.emptyWorld();
    world.globals.tick = kLateTick;
    Dice dice(seed);
    addCrowd(world, 180, 120, 0, 9.0f, dice);
    fixture.begin(world);
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::brokenCollide(fixture.queue(), fixture.view(), how);
    naive::integrate(world);
    naive::collide(world);
    std::erase_if(world.entities, [](const naive::Entity& e) { return e.gone; });
    if (!same(fixture.entities(true, true), world.records())) ++differ;
  }
  return differ;
}

class collide_search : public ::testing::TestWithParam<BroadPhase> {};
INSTANTIATE_TEST_SUITE_P(all, collide_search,
                         ::testing::Values(BroadPhase::ngrid, BroadPhase::grid, BroadPhase::gridHashed,
                                           BroadPhase::bruteForce));

TEST_P(collide_search, a_whole_search_gives_the_naive_result) {
  EXPECT_EQ(differences(GetParam(), cpu::Break::nothing), 0u);
}
TEST_P(collide_search, losing_the_last_candidate_is_noticed) {
  EXPECT_EQ(differences(GetParam(), cpu::Break::dropsLast), 10u);
}
TEST_P(collide_search, a_radius_that_is_too_short_is_noticed) {
  EXPECT_EQ(differences(GetParam(), cpu::Break::shortRadius), 10u);
}
TEST_P(collide_search, a_radius_that_is_half_a_metre_too_short_is_noticed) {
  EXPECT_GT(differences(GetParam(), cpu::Break::shortByHalf), 0u);
}

}  // namespace
}  // namespace gw::test
