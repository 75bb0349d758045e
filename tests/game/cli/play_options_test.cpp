// gpuwars play: its options and what it refuses.
#include <gtest/gtest.h>

#include "tests/game/cli/command_line_samples.h"

namespace gw::test {
namespace {

TEST(PlayOptions, NoArgumentsPlayInAWindow) {
  const PlayOptions o = accepted<PlayOptions>("");
  EXPECT_EQ(o.mode, Mode::arcade);
  EXPECT_FALSE(o.seed.has_value());
  EXPECT_EQ(o.enemies, 8192u);
  EXPECT_EQ(o.autopilot, Autopilot::none);
  EXPECT_EQ(o.device, DeviceOption::automatic);
  EXPECT_EQ(o.broadPhase, BroadPhase::ngrid);
  EXPECT_EQ(o.order, VisitOrder::forward);
  EXPECT_FALSE(o.headless || o.fullscreen || o.mute || o.protectMemory);
  EXPECT_EQ(o.width_px, 1280u);
  EXPECT_EQ(o.height_px, 720u);
}

TEST(PlayOptions, PlayTakesAllItsOptions) {
  const PlayOptions o = accepted<PlayOptions>(
      "play --mode arcade --seed 18446744073709551615 --enemies 1000000 --device cpu --threads 256 --broad-phase brute "
      "--gather exact --sort bitonic --headless --ticks 864000 --autopilot expert --record r.gwr --hashes h.txt "
      "--width 320 --height 4320 --mute --order shuffled --protect-memory --screenshot s.png --assets a");
  EXPECT_EQ(o.seed, UINT64_MAX);
  EXPECT_EQ(o.enemies, 1'000'000u);
  EXPECT_EQ(o.device, DeviceOption::cpu);
  EXPECT_EQ(o.threads, 256u);
  EXPECT_EQ(o.broadPhase, BroadPhase::bruteForce);
  EXPECT_TRUE(o.headless);
  EXPECT_EQ(o.ticks, 864'000u);
  EXPECT_EQ(o.autopilot, Autopilot::expert);
  EXPECT_EQ(o.recordPath, "r.gwr");
  EXPECT_EQ(o.hashesPath, "h.txt");
  EXPECT_EQ(o.screenshotPath, "s.png");
  EXPECT_EQ(o.assetsDir, "a");
  EXPECT_EQ(o.width_px, 320u);
  EXPECT_EQ(o.height_px, 4320u);
  EXPECT_TRUE(o.mute && o.protectMemory);
  EXPECT_EQ(o.order, VisitOrder::shuffled);
}

TEST(PlayOptions, PlayIsTheVerbWhenNoneIsNamed) {
  const PlayOptions o = accepted<PlayOptions>("--seed=5 --fullscreen --autopilot novice --device cuda --order forward");
  EXPECT_EQ(o.seed, 5u);
  EXPECT_TRUE(o.fullscreen);
  EXPECT_EQ(o.autopilot, Autopilot::novice);
  EXPECT_EQ(o.device, DeviceOption::cuda);
}

TEST(PlayOptions, KeepsItsTextForReplays) {
  EXPECT_EQ(optionsOf<PlayOptions>(parseCommandLine({"play", "--seed", "3", "--record", "my run.gwr"})).text,
            "play --seed 3 --record 'my run.gwr'");
}

TEST(PlayOptions, KnowsTheModesByName) {
  const std::pair<const char*, Mode> modes[] = {
      {"arcade", Mode::arcade}, {"deadline", Mode::deadline}, {"swarm", Mode::swarm}, {"practice", Mode::practice}};
  for (const auto& [name, mode] : modes) {
    EXPECT_EQ(optionsOf<PlayOptions>(parseCommandLine({"--mode", name})).mode, mode) << name;
  }
  EXPECT_FALSE(parseCommandLine({"verify", "a", "--mode", "swarm"}).run) << "a replay knows its own";
}

INSTANTIATE_TEST_SUITE_P(
    Play, CommandLineRefusal,
    ::testing::ValuesIn(std::vector<Refusal>{
        {"--mode chess", "'--mode chess' is not known; choose arcade|deadline|swarm|practice"},
        {"--autopilot pro", "'--autopilot pro' is not known; choose novice|expert"},
        {"--enemies 0", "'--enemies 0' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies -5", "'--enemies -5' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies 1000001", "'--enemies 1000001' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies 99999999999999999999",
         "'--enemies 99999999999999999999' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies many", "'--enemies many' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies 10.5", "'--enemies 10.5' is not valid; give a whole number from 1 to 1,000,000"},
        {"--enemies 0x10", "'--enemies 0x10' is not valid; give a whole number from 1 to 1,000,000"},
        {"--seed -1", "'--seed -1' is not valid; give a whole number from 0 to 18,446,744,073,709,551,615"},
        {"--ticks 0", "'--ticks 0' is not valid; give a whole number from 1 to 864,000"},
        {"--ticks 864001", "'--ticks 864001' is not valid; give a whole number from 1 to 864,000"},
        {"--width 319", "'--width 319' is not valid; give a whole number from 320 to 7,680"},
        {"--width 7681", "'--width 7681' is not valid; give a whole number from 320 to 7,680"},
        {"--height 199", "'--height 199' is not valid; give a whole number from 200 to 4,320"},
        {"--headless=yes --ticks 5", "'--headless' takes no value; leave out what follows its '='"},
        {"--seed 1 --seed 2", "'--seed' is given more than once; keep one of them"},
        {"--record --headless",
         "'--record' is followed by '--headless' instead of a file name; add one ('./--headless' if that is the file's "
         "name)"},
        {"--headless", "'--headless' needs '--ticks N'; add it"},
        {"--headless --autopilot expert", "'--headless' needs '--ticks N'; add it"},
        {"--headless --ticks 5 --fullscreen",
         "'--fullscreen' has no effect with '--headless'; leave out one of the two"},
        {"--hashes out", "'--hashes' needs '--headless'; add it"},
        {"--screenshot out", "'--screenshot' needs '--headless'; add it"},
        {"--headless --ticks 5 --record x --hashes x",
         "'--record' and '--hashes' name the same file; give each its own"},
    }));

}  // namespace
}  // namespace gw::test
