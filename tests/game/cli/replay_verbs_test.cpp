// The verbs that read replays, and devices: their options and what they refuse.
#include <gtest/gtest.h>

#include "tests/game/cli/command_line_samples.h"

namespace gw::test {
namespace {

TEST(ReplayVerbs, ReplayTakesAFile) {
  const ReplayOptions o = accepted<ReplayOptions>(
      "replay run.gwr --speed 0.5 --from 600 --device cpu --broad-phase ngrid --width 640 --mute");
  EXPECT_EQ(o.file, "run.gwr");
  EXPECT_EQ(o.speed, 0.5);
  EXPECT_EQ(o.fromTick, 600u);
  EXPECT_EQ(o.width_px, 640u);
  EXPECT_EQ(accepted<ReplayOptions>("replay run.gwr --speed 0.1").speed, 0.1);
  EXPECT_EQ(accepted<ReplayOptions>("replay run.gwr --speed 16").speed, 16);
  EXPECT_FALSE(o.quitAtEnd);
  EXPECT_TRUE(accepted<ReplayOptions>("replay run.gwr --quit-at-end").quitAtEnd);
}

TEST(ReplayVerbs, RenderTakesAFileAndAPlace) {
  const RenderOptions o = accepted<RenderOptions>(
      "render run.gwr --out film.mp4 --from 60 --to 600 --width 1920 --height 1080 --fps 120 --hud off --threads 2");
  EXPECT_EQ(o.file, "run.gwr");
  EXPECT_EQ(o.outPath, "film.mp4");
  EXPECT_EQ(o.fromTick, 60u);
  EXPECT_EQ(o.toTick, 600u);
  EXPECT_EQ(o.framesPerSecond, 120u);
  EXPECT_FALSE(o.hud);
  const RenderOptions usual = accepted<RenderOptions>("render run.gwr --out frames");
  EXPECT_FALSE(usual.fromTick || usual.toTick != 0);
  EXPECT_EQ(usual.framesPerSecond, 60u);
  EXPECT_TRUE(usual.hud);
}

TEST(ReplayVerbs, VerifyTakesFiles) {
  const VerifyOptions o =
      accepted<VerifyOptions>("verify a.gwr b.gwr -j 4 --json out.json --hashes - c.gwr --threads 2 --order reversed");
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"a.gwr", "b.gwr", "c.gwr"}));
  EXPECT_EQ(o.jobs, 4u);
  EXPECT_EQ(o.jsonPath, "out.json");
  EXPECT_EQ(o.hashesPath, "-");
  EXPECT_EQ(o.threads, 2u);
  EXPECT_EQ(o.order, VisitOrder::reversed);
  EXPECT_EQ(accepted<VerifyOptions>("verify a -j2").jobs, 2u);
  EXPECT_EQ(accepted<VerifyOptions>("verify --jobs=3 a").jobs, 3u);
}

TEST(ReplayVerbs, TrimTakesAFileAndWhereToWrite) {
  const TrimOptions o =
      accepted<TrimOptions>("trim run.gwr --out new.gwr --to 600 --device cpu --threads 2 --broad-phase brute");
  EXPECT_EQ(o.file, "run.gwr");
  EXPECT_EQ(o.outPath, "new.gwr");
  EXPECT_EQ(o.toTick, 600u);
  EXPECT_EQ(o.threads, 2u);
  EXPECT_EQ(accepted<TrimOptions>("trim a --out a").toTick, 0u);
}

TEST(ReplayVerbs, DiffTakesTwoFiles) {
  const DiffOptions o = accepted<DiffOptions>("diff a.gwr b.gwr --json");
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"a.gwr", "b.gwr"}));
  EXPECT_EQ(o.jsonPath, "-");
  EXPECT_EQ(accepted<DiffOptions>("diff a b").jsonPath, "");
  EXPECT_EQ(accepted<DiffOptions>("diff --json=out a b").jsonPath, "out");
}

TEST(ReplayVerbs, DevicesListsToAPlaceOrStdout) {
  EXPECT_EQ(accepted<DevicesOptions>("devices").jsonPath, "");
  EXPECT_EQ(accepted<DevicesOptions>("devices --json").jsonPath, "-");
  EXPECT_EQ(accepted<DevicesOptions>("devices --json out.json").jsonPath, "out.json");
}

INSTANTIATE_TEST_SUITE_P(
    ReplayVerbs, CommandLineRefusal,
    ::testing::ValuesIn(std::vector<Refusal>{
        {"verify a -j 0", "'--jobs 0' is not valid; give a whole number from 1 to 256"},
        {"replay a --speed nan", "'--speed nan' is not valid; give a number from 0.1 to 16"},
        {"replay a --speed 0", "'--speed 0' is not valid; give a number from 0.1 to 16"},
        {"replay a --speed fast", "'--speed fast' is not valid; give a number from 0.1 to 16"},
        {"replay a --speed 1e999", "'--speed 1e999' is not valid; give a number from 0.1 to 16"},
        {"replay a --from -1", "'--from -1' is not valid; give a whole number from 0 to 864,000"},
        {"verify a --json - --hashes -", "'--json' and '--hashes' name the same file; give each its own"},
        {"render --out a", "'gpuwars render' needs a file (the replay to draw); add its name"},
        {"render a",
         "'gpuwars render' needs '--out OUT' (a folder for one picture per frame, FILE.png for a single tick, or "
         "FILE.mp4 for a video); add it"},
        {"render a --out b.avi", "'--out b.avi' is not a supported kind of file; give a folder, FILE.png or FILE.mp4"},
        {"render a --out b.mp4 --width 641",
         "'--width 641' and '--height 720' are not valid for a video; give even numbers"},
        {"render a --out b --from 9 --to 8", "'--from 9' comes after '--to 8'; exchange them"},
        {"render a --out b --fps 25", "'--fps 25' is not known; choose 30|60|120"},
        {"render a --out b --hud maybe", "'--hud maybe' is not known; choose on|off"},
        {"replay", "'gpuwars replay' needs a file (the replay to watch); add its name"},
        {"verify --json out", "'gpuwars verify' needs a file (the replays to run again); add its name"},
        {"trim --out b", "'gpuwars trim' needs a file (the replay to run again); add its name"},
        {"trim a", "'gpuwars trim' needs '--out OUT' (write the new replay to OUT, which may be FILE itself); add it"},
        {"trim a --out b --to 0", "'--to 0' is not valid; give a whole number from 1 to 864,000"},
        {"trim a b --out c", "'b' is one file too many; give just one"},
        {"diff", "'gpuwars diff' needs two files (the two replays to compare); add both names"},
        {"diff a", "'gpuwars diff' needs two files (the two replays to compare); add both names"},
        {"diff --json a b", "'gpuwars diff' needs two files (the two replays to compare); add both names"},
        {"diff a b c", "'c' is one file too many; give just two"},
        {"replay a b", "'b' is one file too many; give just one"},
        {"verify a --against cpu --reference b",
         "'--against' cannot be combined with '--reference'; leave out one of the two"},
        {"verify a --heavy --against cpu", "'--heavy' cannot be combined with '--against'; leave out one of the two"},
        {"verify a --reference b --heavy", "'--heavy' cannot be combined with '--reference'; leave out one of the two"},
        {"verify a --reference-options b", "'--reference-options' needs '--reference PROGRAM'; add it"},
        {"verify a --junit x --json x", "'--junit' and '--json' or '--hashes' name the same file; give each its own"},
    }));

}  // namespace
}  // namespace gw::test
