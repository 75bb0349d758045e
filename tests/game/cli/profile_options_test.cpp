// gpuwars profile: its options and what it refuses.
#include <gtest/gtest.h>

#include "tests/game/cli/command_line_samples.h"

namespace gw::test {
namespace {

TEST(ProfileOptions, ProfileTakesASceneOrAReplay) {
  const ProfileOptions o = accepted<ProfileOptions>(
      "profile --out report --scene ramp --seconds 20 --runs 3 --compare ngrid,grid --enemies 512,8192 --headless "
      "--view world --effects off --trace t.json --baseline old.json --paced --width 800 --height 600 --threads 2");
  EXPECT_EQ(o.outPath, "report");
  EXPECT_EQ(o.scene, profile::SceneKind::ramp);
  EXPECT_EQ(o.seconds, 20u);
  EXPECT_EQ(o.runs, 3u);
  EXPECT_EQ(o.compare, "ngrid,grid");
  EXPECT_EQ(o.enemiesList, (std::vector<uint32_t>{512, 8192}));
  EXPECT_TRUE(o.headless && o.wholeWorld && o.paced && !o.effects && !o.drawNothing);
  EXPECT_EQ(o.tracePath, "t.json");
  EXPECT_EQ(o.baselinePath, "old.json");
  const ProfileOptions usual = accepted<ProfileOptions>("profile --out report");
  EXPECT_EQ(usual.scene, profile::SceneKind::fiveMinutes);
  EXPECT_EQ(usual.runs, 10u);
  EXPECT_TRUE(usual.enemiesList.empty() && usual.compare.empty() && usual.effects);
  EXPECT_EQ(accepted<ProfileOptions>("profile --out d --replay run.gwr --no-draw --ticks 600").replayPath, "run.gwr");
}

INSTANTIATE_TEST_SUITE_P(
    Profile, CommandLineRefusal,
    ::testing::ValuesIn(std::vector<Refusal>{
        {"profile", "'gpuwars profile' needs '--out DIR' (the folder of the report; created if missing); add it"},
        {"profile --out d --scene ramp --replay f",
         "'--scene' names what is played, as does '--replay'; leave out one of the two"},
        {"profile --out d --replay f --enemies 5",
         "'--enemies' has no effect with '--replay'; leave out one of the two"},
        {"profile --out d --ticks 60 --seconds 1",
         "'--ticks' sets the length of a run, as does '--seconds'; leave out one of the two"},
        {"profile --out d --headless --no-draw",
         "'--headless' has no effect with '--no-draw'; leave out one of the two"},
        {"profile --out d --no-draw --paced", "'--paced' has no effect with '--no-draw'; leave out one of the two"},
        {"profile --out d --no-draw --scene menu", "'--scene menu' is drawn; leave out '--no-draw'"},
        {"profile --out d --compare ngrid --broad-phase grid",
         "'--compare' names the broad phases; leave out '--broad-phase'"},
        {"profile --out d --thesis",
         "'gpuwars profile' plays exact games and measures an inexact gather beside them; use '--compare "
         "ngrid,thesis'"},
        {"profile --out d --scene chess", "'--scene chess' is not known; choose five-minutes|ramp|swarm|menu"},
        {"profile --out d --enemies 5,many",
         "'--enemies 5,many' is not valid; give whole numbers from 1 to 1000000, separated by commas"},
        {"profile --out d --enemies 5,",
         "'--enemies 5,' is not valid; give whole numbers from 1 to 1000000, separated by commas"},
        {"profile --out d --enemies 0",
         "'--enemies 0' is not valid; give whole numbers from 1 to 1000000, separated by commas"},
        {"profile --out d --runs 0", "'--runs 0' is not valid; give a whole number from 1 to 1,000"},
        {"profile --out d --ticks 59", "'--ticks 59' is not valid; give a whole number from 60 to 864,000"},
        {"profile file.gwr", "'file.gwr' is not understood; 'gpuwars profile' takes options only"},
        {"profile --out d --enemies 5,9,5", "'--enemies 5,9,5' names 5 twice; leave out one of the two"},
        {"profile --out d --sort bitonic --compare grid,brute",
         "'--sort' is about the contender ngrid, which '--compare' does not name; leave out one of the two"},
    }));

}  // namespace
}  // namespace gw::test
