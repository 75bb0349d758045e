// The command line, option by option: what it gives, and the sentence for what it refuses.
#include "game/cli/command_line.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace gw::test {
namespace {

ParsedCommandLine parse(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return parseCommandLine(arguments);
}

Options accepted(const std::string& line) {
  const ParsedCommandLine parsed = parse(line);
  EXPECT_TRUE(parsed.run) << line << ": " << parsed.error;
  EXPECT_EQ(parsed.error, "");
  return parsed.options;
}

TEST(CommandLine, NoArgumentsPlayInAWindow) {
  const Options o = accepted("");
  EXPECT_EQ(o.verb, Verb::play);
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

TEST(CommandLine, PlayTakesAllItsOptions) {
  const Options o = accepted(
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

TEST(CommandLine, PlayIsTheVerbWhenNoneIsNamed) {
  const Options o = accepted("--seed=5 --fullscreen --autopilot novice --device cuda --order forward");
  EXPECT_EQ(o.verb, Verb::play);
  EXPECT_EQ(o.seed, 5u);
  EXPECT_TRUE(o.fullscreen);
  EXPECT_EQ(o.autopilot, Autopilot::novice);
  EXPECT_EQ(o.device, DeviceOption::cuda);
}

TEST(CommandLine, BlocksAreWholeWarps) {
  EXPECT_FALSE(accepted("").cudaCheck);
  EXPECT_TRUE(accepted("--headless --ticks 1 --cuda-check").cudaCheck);
  EXPECT_EQ(accepted("").blockSize, 128u);
  for (const uint32_t size : {32u, 64u, 256u, 1024u}) {
    EXPECT_EQ(accepted("verify a --block-size " + std::to_string(size)).blockSize, size);
  }
}

TEST(CommandLine, ReplayTakesAFile) {
  const Options o =
      accepted("replay run.gwr --speed 0.5 --from 600 --device cpu --broad-phase ngrid --width 640 --mute");
  EXPECT_EQ(o.verb, Verb::replay);
  ASSERT_EQ(o.files.size(), 1u);
  EXPECT_EQ(o.files[0], "run.gwr");
  EXPECT_EQ(o.speed, 0.5);
  EXPECT_EQ(o.fromTick, 600u);
  EXPECT_EQ(o.width_px, 640u);
  EXPECT_EQ(accepted("replay run.gwr --speed 0.1").speed, 0.1);
  EXPECT_EQ(accepted("replay run.gwr --speed 16").speed, 16);
  EXPECT_FALSE(o.quitAtEnd);
  EXPECT_TRUE(accepted("replay run.gwr --quit-at-end").quitAtEnd);
}

TEST(CommandLine, RenderTakesAFileAndAPlace) {
  const Options o = accepted(
      "render run.gwr --out film.mp4 --from 60 --to 600 --width 1920 --height 1080 --fps 120 --hud off --threads 2");
  EXPECT_EQ(o.verb, Verb::render);
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"run.gwr"}));
  EXPECT_EQ(o.outPath, "film.mp4");
  EXPECT_EQ(o.fromTick, 60u);
  EXPECT_EQ(o.toTick, 600u);
  EXPECT_EQ(o.framesPerSecond, 120u);
  EXPECT_FALSE(o.hud);
  const Options usual = accepted("render run.gwr --out frames");
  EXPECT_FALSE(usual.fromTick || usual.toTick != 0);
  EXPECT_EQ(usual.framesPerSecond, 60u);
  EXPECT_TRUE(usual.hud);
}

TEST(CommandLine, VerifyTakesFiles) {
  const Options o = accepted("verify a.gwr b.gwr -j 4 --json out.json --hashes - c.gwr --threads 2 --order reversed");
  EXPECT_EQ(o.verb, Verb::verify);
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"a.gwr", "b.gwr", "c.gwr"}));
  EXPECT_EQ(o.jobs, 4u);
  EXPECT_EQ(o.jsonPath, "out.json");
  EXPECT_EQ(o.hashesPath, "-");
  EXPECT_EQ(o.threads, 2u);
  EXPECT_EQ(o.order, VisitOrder::reversed);
  EXPECT_EQ(accepted("verify a -j2").jobs, 2u);
  EXPECT_EQ(accepted("verify --jobs=3 a").jobs, 3u);
}

TEST(CommandLine, ProfileTakesASceneOrAReplay) {
  const Options o = accepted(
      "profile --out report --scene ramp --seconds 20 --runs 3 --compare ngrid,grid --enemies 512,8192 --headless "
      "--view world --effects off --trace t.json --baseline old.json --paced --width 800 --height 600 --threads 2");
  EXPECT_EQ(o.verb, Verb::profile);
  EXPECT_EQ(o.outPath, "report");
  EXPECT_EQ(o.scene, profile::SceneKind::ramp);
  EXPECT_EQ(o.seconds, 20u);
  EXPECT_EQ(o.runs, 3u);
  EXPECT_EQ(o.compare, "ngrid,grid");
  EXPECT_EQ(o.enemiesList, (std::vector<uint32_t>{512, 8192}));
  EXPECT_TRUE(o.headless && o.wholeWorld && o.paced && !o.effects && !o.drawNothing);
  EXPECT_EQ(o.tracePath, "t.json");
  EXPECT_EQ(o.baselinePath, "old.json");
  const Options usual = accepted("profile --out report");
  EXPECT_EQ(usual.scene, profile::SceneKind::fiveMinutes);
  EXPECT_EQ(usual.runs, 10u);
  EXPECT_TRUE(usual.enemiesList.empty() && usual.compare.empty() && usual.effects);
  EXPECT_EQ(accepted("profile --out d --replay run.gwr --no-draw --ticks 600").replayPath, "run.gwr");
}

TEST(CommandLine, TrimTakesAFileAndWhereToWrite) {
  const Options o = accepted("trim run.gwr --out new.gwr --to 600 --device cpu --threads 2 --broad-phase brute");
  EXPECT_EQ(o.verb, Verb::trim);
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"run.gwr"}));
  EXPECT_EQ(o.outPath, "new.gwr");
  EXPECT_EQ(o.toTick, 600u);
  EXPECT_EQ(o.threads, 2u);
  EXPECT_EQ(accepted("trim a --out a").toTick, 0u);
}

TEST(CommandLine, DiffTakesTwoFiles) {
  const Options o = accepted("diff a.gwr b.gwr --json");
  EXPECT_EQ(o.verb, Verb::diff);
  EXPECT_EQ(o.files, (std::vector<std::filesystem::path>{"a.gwr", "b.gwr"}));
  EXPECT_EQ(o.jsonPath, "-");
  EXPECT_EQ(accepted("diff a b").jsonPath, "");
  EXPECT_EQ(accepted("diff --json=out a b").jsonPath, "out");
}

TEST(CommandLine, TakesGatherAndSort) {
  const Options none = accepted("");
  EXPECT_FALSE(none.gather || none.sort);
  const Options both = accepted("--gather fixed --sort odd-even");
  EXPECT_EQ(both.gather, Gather::fixed);
  EXPECT_EQ(both.sort, Sort::oddEven);
  EXPECT_EQ(accepted("--gather adaptive --broad-phase ngrid").gather, Gather::adaptive);
  EXPECT_EQ(accepted("--gather exact --broad-phase brute").gather, Gather::exact);
  EXPECT_EQ(accepted("--broad-phase grid").broadPhase, BroadPhase::grid);
  EXPECT_EQ(accepted("--broad-phase grid-hashed").broadPhase, BroadPhase::gridHashed);
  // What the file holds is not known yet.
  EXPECT_EQ(accepted("verify a --sort odd-even").sort, Sort::oddEven);
}

TEST(CommandLine, ThesisIsShorthand) {
  for (const char* line : {"--thesis", "--thesis --gather adaptive", "--sort bitonic --thesis", "verify a --thesis"}) {
    const Options o = accepted(line);
    EXPECT_TRUE(o.thesis);
    EXPECT_EQ(o.gather, Gather::adaptive) << line;
    EXPECT_EQ(o.sort, Sort::bitonic) << line;
  }
}

TEST(CommandLine, FilesMayBeginWithADashAfterTwo) {
  EXPECT_EQ(accepted("verify -- -a.gwr --b").files, (std::vector<std::filesystem::path>{"-a.gwr", "--b"}));
}

TEST(CommandLine, DevicesListsToAPlaceOrStdout) {
  EXPECT_EQ(accepted("devices").jsonPath, "");
  EXPECT_EQ(accepted("devices --json").jsonPath, "-");
  EXPECT_EQ(accepted("devices --json out.json").jsonPath, "out.json");
}

TEST(CommandLine, KeepsItsTextForReplays) {
  EXPECT_EQ(parseCommandLine({"play", "--seed", "3", "--record", "my run.gwr"}).options.text,
            "play --seed 3 --record 'my run.gwr'");
}

TEST(CommandLine, HelpAndVersionGoToStdout) {
  for (const char* line : {"--help", "-h", "play --help", "replay --help", "verify -h", "devices --help", "--version",
                           "verify --version", "replay --help --nonsense"}) {
    const ParsedCommandLine parsed = parse(line);
    EXPECT_FALSE(parsed.run) << line;
    EXPECT_EQ(parsed.code, ExitCode::fine) << line;
    EXPECT_EQ(parsed.error, "") << line;
    EXPECT_TRUE(parsed.output.ends_with("\n")) << line;
  }
  EXPECT_NE(parse("--help").output.find("verify"), std::string::npos);
  EXPECT_NE(parse("verify --help").output.find("--jobs"), std::string::npos);
  EXPECT_NE(parse("play --help").output.find("--autopilot novice|expert"), std::string::npos);
  EXPECT_NE(parse("play --help").output.find("--thesis"), std::string::npos);
  EXPECT_NE(parse("play --help").output.find("--gather exact|adaptive|fixed"), std::string::npos);
  EXPECT_EQ(parse("--version").output.rfind("gpuwars ", 0), 0u);
}

TEST(CommandLine, HelpListsEachOptionOnceUnderItsHeading) {
  EXPECT_EQ(parse("devices --help").output,
            "Say which devices there are and which one 'auto' takes.\n"
            "Usage: gpuwars devices [OPTIONS]\n"
            "\n"
            "Options:\n"
            "  -h,--help                   print this help and exit\n"
            "  --version                   print the version and exit\n"
            "  --json [OUT]                write the list as JSON to OUT, or to stdout\n");
  const std::string diff = parse("diff --help").output;
  EXPECT_NE(diff.find("Usage: gpuwars diff [OPTIONS] FILE FILE\n\nFiles:\n  FILE                        the two"),
            std::string::npos)
      << diff;
  EXPECT_NE(parse("verify --help").output.find("Usage: gpuwars verify [OPTIONS] FILE...\n"), std::string::npos);
  for (const std::string verb : {"play", "replay", "verify", "render", "profile", "trim", "diff", "devices", "probe"}) {
    std::istringstream lines(parse(verb + " --help").output);
    std::map<std::string, int> seen;
    for (std::string line; std::getline(lines, line);) {
      const size_t start = line.find_first_not_of(' ');
      if (line.ends_with(":")) ++seen[line];
      if (start == 2 && line[2] == '-') ++seen[line.substr(2, line.find(' ', 2) - 2)];
    }
    EXPECT_EQ(seen["Options:"], 1) << verb;
    EXPECT_EQ(seen["--version"], 1) << verb;
    for (const auto& [what, times] : seen) EXPECT_EQ(times, 1) << verb << ": " << what;
  }
}

// CLI11 itself makes lists of what stands in brackets, and gives some words a meaning of their own.
TEST(CommandLine, FileNamesAreWhatTheyAre) {
  using Files = std::vector<std::filesystem::path>;
  for (const std::string name : {"[run].gwr", "[run]", "[a,b]", "[]", "[[a]]", "{a}", "++", "a,b", "@a", "%%", "%%[a]",
                                 "'a'", "\"a\"", "a=[b]", "\x01", "\x01[a]", "a b", "b\"(a)\""}) {
    for (const std::string verb : {"replay", "verify", "probe"}) {
      EXPECT_EQ(parseCommandLine({verb, name}).options.files, Files{name}) << verb << ' ' << name;
    }
    const ParsedCommandLine trim = parseCommandLine({"trim", name, "--out", name});
    EXPECT_EQ(trim.options.files, Files{name}) << trim.error;
    EXPECT_EQ(trim.options.outPath, name);
    const ParsedCommandLine render = parseCommandLine({"render", "--out=" + name, "--", name});
    EXPECT_EQ(render.options.files, Files{name}) << render.error;
    EXPECT_EQ(render.options.outPath, name);
    EXPECT_EQ(parseCommandLine({"diff", name, "b"}).options.files, (Files{name, "b"})) << name;
    EXPECT_EQ(parseCommandLine({"verify", "a", name, "b"}).options.files, (Files{"a", name, "b"})) << name;
    EXPECT_EQ(parseCommandLine({"--record", name}).options.recordPath, name);
    EXPECT_EQ(parseCommandLine({"devices", "--json", name}).options.jsonPath, name);
    EXPECT_EQ(parseCommandLine({"profile", "--out", name, "--replay", name}).options.replayPath, name);
    EXPECT_EQ(
        parseCommandLine({"verify", "a", "--reference", name, "--reference-options", name}).options.referenceOptions,
        name);
  }
  EXPECT_EQ(parseCommandLine({"verify", "--", "--out=[a]"}).options.files, Files{"--out=[a]"});
  EXPECT_EQ(parseCommandLine({"play", "[a]"}).error, "'[a]' is not understood; 'gpuwars play' takes options only");
}

struct Refusal {
  const char* line;
  const char* error;  // all of it
};

const Refusal kRefusals[] = {
    // How neighbours are found.
    {"--gather adaptive --sort full",
     "'--sort full' does not keep the order that '--gather adaptive' needs; choose '--sort bitonic' or '--sort "
     "odd-even'"},
    {"--gather fixed --sort frozen",
     "'--sort frozen' does not keep the order that '--gather fixed' needs; choose '--sort bitonic' or '--sort "
     "odd-even'"},
    {"--sort frozen --broad-phase grid",
     "'--sort frozen' keeps the NGrid in order, which '--broad-phase grid' does without; leave out one of the two"},
    // Profiles.
    {"profile", "'gpuwars profile' needs a folder for its report; add '--out DIR'"},
    {"profile --out d --scene ramp --replay f", "'--scene' and '--replay' each name what is played; leave out one"},
    {"profile --out d --replay f --enemies 5", "'--enemies' is what '--replay' was recorded with; leave it out"},
    {"profile --out d --ticks 60 --seconds 1",
     "'--ticks' and '--seconds' both name the length of a run; leave out one"},
    {"profile --out d --headless --no-draw", "'--no-draw' needs no '--headless'; leave out one of the two"},
    {"profile --out d --no-draw --paced", "'--paced' has no effect with '--no-draw'; leave out one of the two"},
    {"profile --out d --no-draw --scene menu", "'--scene menu' is drawn; leave out '--no-draw'"},
    {"profile --out d --compare ngrid --broad-phase grid",
     "'--compare' names the broad phases; leave '--broad-phase' out"},
    {"profile --out d --thesis",
     "a profile plays exact games, and measures an inexact gather beside one; use '--compare ngrid,thesis'"},
    {"profile --out d --scene chess", "'--scene chess' is not known; choose five-minutes|ramp|swarm|menu"},
    {"profile --out d --enemies 5,many",
     "'--enemies 5,many' does not work; give whole numbers from 1 to 1000000, separated by commas"},
    {"profile --out d --enemies 5,",
     "'--enemies 5,' does not work; give whole numbers from 1 to 1000000, separated by commas"},
    {"profile --out d --enemies 0",
     "'--enemies 0' does not work; give whole numbers from 1 to 1000000, separated by commas"},
    {"profile --out d --runs 0", "'--runs 0' does not work; give a whole number from 1 to 1,000"},
    {"profile --out d --ticks 59", "'--ticks 59' does not work; give a whole number from 60 to 864,000"},
    {"profile file.gwr", "'file.gwr' is not understood; 'gpuwars profile' takes options only"},
    // Values.
    {"--mode chess", "'--mode chess' is not known; choose arcade|deadline|swarm|practice"},
    {"--device gpu", "'--device gpu' is not known; choose auto|cuda|cpu"},
    {"--broad-phase tree", "'--broad-phase tree' is not known; choose ngrid|grid|grid-hashed|brute"},
    {"--autopilot pro", "'--autopilot pro' is not known; choose novice|expert"},
    {"--autopilot", "'--autopilot' needs a value; see 'gpuwars play --help'"},
    {"--order random", "'--order random' is not known; choose forward|reversed|shuffled"},
    {"--enemies 0", "'--enemies 0' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies -5", "'--enemies -5' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies 1000001", "'--enemies 1000001' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies 99999999999999999999",
     "'--enemies 99999999999999999999' does not work; give a whole number from 1 to "
     "1,000,000"},
    {"--enemies many", "'--enemies many' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies 10.5", "'--enemies 10.5' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies 0x10", "'--enemies 0x10' does not work; give a whole number from 1 to 1,000,000"},
    {"--enemies", "'--enemies' needs a value; see 'gpuwars play --help'"},
    {"--seed -1", "'--seed -1' does not work; give a whole number from 0 to 18,446,744,073,709,551,615"},
    {"--threads 257", "'--threads 257' does not work; give a whole number from 0 to 256"},
    {"--ticks 0", "'--ticks 0' does not work; give a whole number from 1 to 864,000"},
    {"--ticks 864001", "'--ticks 864001' does not work; give a whole number from 1 to 864,000"},
    {"--width 319", "'--width 319' does not work; give a whole number from 320 to 7,680"},
    {"--width 7681", "'--width 7681' does not work; give a whole number from 320 to 7,680"},
    {"--height 199", "'--height 199' does not work; give a whole number from 200 to 4,320"},
    {"--headless=yes --ticks 5", "'--headless' takes no value; leave out what follows its '='"},
    {"--seed 1 --seed 2", "'--seed' is given more than once; keep one of them"},
    {"verify a -j 0", "'--jobs 0' does not work; give a whole number from 1 to 256"},
    {"replay a --speed nan", "'--speed nan' does not work; give a number from 0.1 to 16"},
    {"replay a --speed 0", "'--speed 0' does not work; give a number from 0.1 to 16"},
    {"replay a --speed fast", "'--speed fast' does not work; give a number from 0.1 to 16"},
    {"replay a --speed 1e999", "'--speed 1e999' does not work; give a number from 0.1 to 16"},
    {"replay a --from -1", "'--from -1' does not work; give a whole number from 0 to 864,000"},
    {"--record --headless",
     "'--record' is followed by '--headless' where its file name should be; give it one "
     "('./--headless' if it is really called so)"},
    {"--record", "'--record' needs a value; see 'gpuwars play --help'"},
    {"--gather none", "'--gather none' is not known; choose exact|adaptive|fixed"},
    {"--sort quick", "'--sort quick' is not known; choose bitonic|odd-even|full|frozen"},
    {"--thesis=2d", "'--thesis' takes no value; leave out what follows its '='"},
    {"--thesis --thesis --gather", "'--gather' needs a value; see 'gpuwars play --help'"},
    // Contradictions.
    {"--sort odd-even",
     "'--sort odd-even' does not keep the order that an exact gather needs; add '--gather adaptive' or "
     "'--gather fixed'"},
    {"verify a --gather exact --sort odd-even",
     "'--sort odd-even' does not keep the order that an exact gather needs; add '--gather adaptive' or "
     "'--gather fixed'"},
    {"--gather fixed --broad-phase brute",
     "'--gather fixed' asks the NGrid, which '--broad-phase brute' does without; leave out one of the two"},
    {"--gather adaptive --broad-phase grid-hashed",
     "'--gather adaptive' asks the NGrid, which '--broad-phase grid-hashed' does without; leave out one of the two"},
    {"verify a --thesis --broad-phase brute",
     "'--thesis' asks the NGrid, which '--broad-phase brute' does without; leave out one of the two"},
    {"--thesis --gather fixed",
     "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--gather fixed' out"},
    {"--thesis --gather exact",
     "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--gather exact' out"},
    {"replay a --sort odd-even --thesis",
     "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--sort odd-even' out"},
    {"--headless", "'--headless' does not end by itself; give '--ticks N' too"},
    {"--headless --autopilot expert", "'--headless' does not end by itself; give '--ticks N' too"},
    {"--headless --ticks 5 --fullscreen", "'--headless' has no window for '--fullscreen'; leave out one of the two"},
    {"--hashes out", "'--hashes' is for runs without a window; add '--headless'"},
    {"--screenshot out", "'--screenshot' is for runs without a window; add '--headless'"},
    {"--headless --ticks 5 --record x --hashes x", "'--record' and '--hashes' name the same file; give each its own"},
    {"verify a --json - --hashes -", "'--json' and '--hashes' name the same place; give each its own"},
    {"--block-size 31", "'--block-size 31' does not work; give a whole number from 32 to 1,024"},
    {"--block-size 1056", "'--block-size 1056' does not work; give a whole number from 32 to 1,024"},
    {"verify a --block-size 100", "'--block-size 100' does not work; give a multiple of 32 from 32 to 1024"},
    {"--device cpu --cuda-check", "'--cuda-check' is about the cuda device; leave it out or choose '--device cuda'"},
    {"--device cpu --block-size 64", "'--block-size' is about the cuda device; leave it out or choose '--device cuda'"},
    {"--device cuda --order reversed",
     "'--order' and '--protect-memory' are about the cpu device; leave them out or choose '--device cpu'"},
    {"--device cuda --protect-memory",
     "'--order' and '--protect-memory' are about the cpu device; leave them out or choose '--device cpu'"},
    // Verbs, files and options in the wrong place.
    {"run.gwr",
     "'run.gwr' is not a verb; choose play, replay, verify, render, profile, trim, diff or devices (to watch a file: "
     "'gpuwars "
     "replay FILE')"},
    {"play run.gwr", "'run.gwr' is not understood; 'gpuwars play' takes options only"},
    {"devices cpu", "'cpu' is not understood; 'gpuwars devices' takes options only"},
    {"render --out a", "'gpuwars render' needs a replay; name the file"},
    {"render a", "'gpuwars render' has nowhere to draw to; give '--out' a folder, FILE.png or FILE.mp4"},
    {"render a --out b.avi", "'--out b.avi' is no kind of file that can be made; give a folder, FILE.png or FILE.mp4"},
    {"render a --out b.mp4 --width 641", "'--width 641' and '--height 720' are no size for a film; give even numbers"},
    {"render a --out b --from 9 --to 8", "'--from 9' comes after '--to 8'; exchange them"},
    {"render a --out b --fps 25", "'--fps 25' is not known; choose 30|60|120"},
    {"render a --out b --hud maybe", "'--hud maybe' is not known; choose on|off"},
    {"render a --out b --speed 2", "'--speed' belongs to 'gpuwars replay', not to 'gpuwars render'; leave it out"},
    {"replay", "'gpuwars replay' needs a replay; name the file"},
    {"verify --json out", "'gpuwars verify' needs a replay; name the file"},
    {"trim --out b", "'gpuwars trim' needs a replay; name the file"},
    {"trim a", "'gpuwars trim' needs to know what to write; add '--out FILE'"},
    {"trim a --out b --to 0", "'--to 0' does not work; give a whole number from 1 to 864,000"},
    {"trim a b --out c", "'b' is one file too many; give just one"},
    {"diff", "'gpuwars diff' needs a replay; name the file"},
    {"diff a", "'gpuwars diff' compares two replays; name both files"},
    {"diff --json a b", "'gpuwars diff' compares two replays; name both files"},
    {"diff a b c", "'c' is one file too many; give just two"},
    {"diff a b --threads 1", "'--threads' belongs to 'gpuwars play', not to 'gpuwars diff'; leave it out"},
    {"replay a b", "'b' is one file too many; give just one"},
    {"replay a --seed 3", "'--seed' belongs to 'gpuwars play', not to 'gpuwars replay'; leave it out"},
    {"verify a --autopilot expert", "'--autopilot' belongs to 'gpuwars play', not to 'gpuwars verify'; leave it out"},
    {"verify a --record=x", "'--record' belongs to 'gpuwars play', not to 'gpuwars verify'; leave it out"},
    {"play --speed 2", "'--speed' belongs to 'gpuwars replay', not to 'gpuwars play'; leave it out"},
    {"devices --device cpu", "'--device' belongs to 'gpuwars play', not to 'gpuwars devices'; leave it out"},
    {"--sed 3", "'--sed' is not an option; see 'gpuwars play --help'"},
    {"verify a --frobnicate=3", "'--frobnicate' is not an option; see 'gpuwars verify --help'"},
    {"-x", "'-x' is not an option; see 'gpuwars play --help'"},
};

class CommandLineRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(CommandLineRefusal, IsOneSentenceAndExitCodeTwo) {
  const ParsedCommandLine parsed = parse(GetParam().line);
  EXPECT_FALSE(parsed.run);
  EXPECT_EQ(parsed.code, ExitCode::badUsage);
  EXPECT_EQ(parsed.error, GetParam().error);
  EXPECT_EQ(parsed.output, "");
}

INSTANTIATE_TEST_SUITE_P(Each, CommandLineRefusal, ::testing::ValuesIn(kRefusals));

TEST(CommandLine, KnowsTheModesByName) {
  const std::pair<const char*, Mode> modes[] = {
      {"arcade", Mode::arcade}, {"deadline", Mode::deadline}, {"swarm", Mode::swarm}, {"practice", Mode::practice}};
  for (const auto& [name, mode] : modes) {
    const ParsedCommandLine parsed = parseCommandLine({"--mode", name});
    EXPECT_TRUE(parsed.run) << parsed.error;
    EXPECT_EQ(parsed.options.mode, mode) << name;
  }
  EXPECT_FALSE(parseCommandLine({"verify", "a", "--mode", "swarm"}).run) << "a replay knows its own";
}

TEST(CommandLine, EmptyAndOddArgumentsAreRefused) {
  EXPECT_EQ(parseCommandLine({""}).code, ExitCode::badUsage);
  EXPECT_EQ(parseCommandLine({"verify", ""}).error, "a file name is empty; give the file's name");
  EXPECT_EQ(parseCommandLine({"--record", ""}).error, "'--record' has an empty name; give it a file name");
  EXPECT_EQ(parseCommandLine({"--mode", "a\nb"}).error,
            "'--mode a?b' is not known; choose arcade|deadline|swarm|practice");
  EXPECT_EQ(parseCommandLine({"--mode", ""}).error, "'--mode ' is not known; choose arcade|deadline|swarm|practice");
}

// Nothing that a user can type may throw or crash.
TEST(CommandLine, SurvivesAnyThreeWords) {
  const std::vector<std::string> words = {"trim",     "diff", "play",       "verify",    "replay", "devices", "--",
                                          "-",        "",     "--=",        "=",         "-j",     "-j=",     "--json",
                                          "--seed",   "--h",  "--seed=",    "[a,b]",     "[]",     "%%",      "-5",
                                          "\x01\xff", "@x",   "--headless", "--ticks=1", "a",      "{}",      "-hv"};
  for (const std::string& a : words) {
    for (const std::string& b : words) {
      for (const std::string& c : words) {
        const ParsedCommandLine parsed = parseCommandLine({a, b, c});
        ASSERT_EQ(parsed.code == ExitCode::badUsage, !parsed.error.empty()) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

}  // namespace
}  // namespace gw::test
