// The command line as a whole: verbs, help, and arguments of every kind.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tests/game/cli/command_line_samples.h"

namespace gw::test {
namespace {

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
            "List the devices and show which one 'auto' selects.\n"
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
    EXPECT_NE(parse("--help").output.find("\n  " + verb + " "), std::string::npos);
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

TEST(CommandLine, FilesMayBeginWithADashAfterTwo) {
  EXPECT_EQ(accepted<VerifyOptions>("verify -- -a.gwr --b").files,
            (std::vector<std::filesystem::path>{"-a.gwr", "--b"}));
}

// CLI11 itself makes lists of what stands in brackets, and gives some words a meaning of their own.
TEST(CommandLine, FileNamesAreWhatTheyAre) {
  using Files = std::vector<std::filesystem::path>;
  for (const std::string name : {"[run].gwr", "[run]", "[a,b]", "[]", "[[a]]", "{a}", "++", "a,b", "@a", "%%", "%%[a]",
                                 "'a'", "\"a\"", "a=[b]", "\x01", "\x01[a]", "a b", "b\"(a)\""}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(optionsOf<ReplayOptions>(parseCommandLine({"replay", name})).file, name);
    EXPECT_EQ(optionsOf<VerifyOptions>(parseCommandLine({"verify", name})).files, Files{name});
    EXPECT_EQ(optionsOf<ProbeOptions>(parseCommandLine({"probe", name})).file, name);
    const TrimOptions trim = optionsOf<TrimOptions>(parseCommandLine({"trim", name, "--out", name}));
    EXPECT_EQ(trim.file, name);
    EXPECT_EQ(trim.outPath, name);
    const RenderOptions render = optionsOf<RenderOptions>(parseCommandLine({"render", "--out=" + name, "--", name}));
    EXPECT_EQ(render.file, name);
    EXPECT_EQ(render.outPath, name);
    EXPECT_EQ(optionsOf<DiffOptions>(parseCommandLine({"diff", name, "b"})).files, (Files{name, "b"}));
    EXPECT_EQ(optionsOf<VerifyOptions>(parseCommandLine({"verify", "a", name, "b"})).files, (Files{"a", name, "b"}));
    EXPECT_EQ(optionsOf<PlayOptions>(parseCommandLine({"--record", name})).recordPath, name);
    EXPECT_EQ(optionsOf<DevicesOptions>(parseCommandLine({"devices", "--json", name})).jsonPath, name);
    EXPECT_EQ(optionsOf<ProfileOptions>(parseCommandLine({"profile", "--out", name, "--replay", name})).replayPath,
              name);
    EXPECT_EQ(
        optionsOf<VerifyOptions>(parseCommandLine({"verify", "a", "--reference", name, "--reference-options", name}))
            .referenceOptions,
        name);
  }
  EXPECT_EQ(optionsOf<VerifyOptions>(parseCommandLine({"verify", "--", "--out=[a]"})).files, Files{"--out=[a]"});
  EXPECT_EQ(parseCommandLine({"play", "[a]"}).error, "'[a]' is not understood; 'gpuwars play' takes options only");
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

INSTANTIATE_TEST_SUITE_P(
    Words, CommandLineRefusal,
    ::testing::ValuesIn(std::vector<Refusal>{
        {"--autopilot", "'--autopilot' needs a value; see 'gpuwars play --help'"},
        {"--enemies", "'--enemies' needs a value; see 'gpuwars play --help'"},
        {"--record", "'--record' needs a value; see 'gpuwars play --help'"},
        {"--thesis=2d", "'--thesis' takes no value; leave out what follows its '='"},
        {"--thesis --thesis --gather", "'--gather' needs a value; see 'gpuwars play --help'"},
        {"run.gwr",
         "'run.gwr' is not a verb; choose play, replay, verify, render, profile, trim, diff, devices or probe (to "
         "watch a file: 'gpuwars replay FILE')"},
        {"play run.gwr", "'run.gwr' is not understood; 'gpuwars play' takes options only"},
        {"devices cpu", "'cpu' is not understood; 'gpuwars devices' takes options only"},
        {"render a --out b --speed 2", "'--speed' belongs to 'gpuwars replay', not to 'gpuwars render'; leave it out"},
        {"diff a b --threads 1", "'--threads' belongs to 'gpuwars play', not to 'gpuwars diff'; leave it out"},
        {"replay a --seed 3", "'--seed' belongs to 'gpuwars play', not to 'gpuwars replay'; leave it out"},
        {"verify a --autopilot expert",
         "'--autopilot' belongs to 'gpuwars play', not to 'gpuwars verify'; leave it out"},
        {"verify a --record=x", "'--record' belongs to 'gpuwars play', not to 'gpuwars verify'; leave it out"},
        {"play --speed 2", "'--speed' belongs to 'gpuwars replay', not to 'gpuwars play'; leave it out"},
        {"devices --device cpu", "'--device' belongs to 'gpuwars play', not to 'gpuwars devices'; leave it out"},
        {"--sed 3", "'--sed' is not an option; see 'gpuwars play --help'"},
        {"verify a --frobnicate=3", "'--frobnicate' is not an option; see 'gpuwars verify --help'"},
        {"-x", "'-x' is not an option; see 'gpuwars play --help'"},
    }));

}  // namespace
}  // namespace gw::test
