// Options of a command that is no game's: values, rules among options, and the sentences of refusals.
#include "host/cli/option_set.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::test {
namespace {

enum class Colour { red, green };
constexpr Choice<Colour> kColours[] = {{"red", Colour::red}, {"green", Colour::green}};

struct Painting {
  std::optional<Colour> colour;
  std::optional<uint64_t> seed;
  uint32_t width = 10;
  double scale = 1;
  bool quiet = false, loud = false;
  std::filesystem::path out, list;
  std::string title;
  std::vector<std::filesystem::path> files;

  void declare(OptionSet& options) {
    options.choice("--colour", kColours, "of the paint", "none", colour);
    options.integer("--seed", "of the brush", 0, UINT64_MAX, seed);
    options.integerMultiple("-w,--width", "in pixels (10)", 10, 5000, 10, width);
    options.number("--scale", "of it all (1)", 0.5, 2, scale);
    options.flag("--quiet", "no sound", quiet);
    options.flag("--loud", "much sound", loud, "Sound");
    options.path("--out", "where it goes", "OUT", out);
    options.pathOrStdout("--list", "write a list", "OUT", list);
    options.text("--title", "its name", "TEXT", [this](const std::string& given) { title = given; });
    options.files("FILE", "the sketches", 0, 2, files);
    options.exclude("--quiet", "has no effect with", "--loud");
    options.need("--list", "--out");
  }
};

// The sentence; empty when the arguments are accepted.
std::string read(Painting& painting, const std::vector<std::string>& arguments, bool outRequired = false) {
  OptionSet options("paint wall", "paint 1");
  painting.declare(options);
  if (outRequired) options.require("--out");
  try {
    EXPECT_EQ(options.parse(arguments), OptionSet::Request::run);
    options.read();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.code, ExitCode::badUsage);
    return error.what();
  }
  return "";
}

std::string refusal(const std::vector<std::string>& arguments, bool outRequired = false) {
  Painting painting;
  return read(painting, arguments, outRequired);
}

TEST(OptionSet, LeavesAloneWhatIsNotGiven) {
  Painting p;
  EXPECT_EQ(read(p, {}), "");
  EXPECT_FALSE(p.colour || p.seed || p.quiet || p.loud);
  EXPECT_EQ(p.width, 10u);
  EXPECT_EQ(p.scale, 1);
  EXPECT_TRUE(p.out.empty() && p.list.empty() && p.title.empty() && p.files.empty());
}

TEST(OptionSet, StoresEveryKindOfValue) {
  Painting p;
  EXPECT_EQ(read(p, {"--colour", "green", "--seed=18446744073709551615", "-w", "120", "--scale", "0.5", "--quiet", "a",
                     "--out", "[b]", "--list", "--title", "--words of any kind", "c"}),
            "");
  EXPECT_EQ(p.colour, Colour::green);
  EXPECT_EQ(p.seed, UINT64_MAX);
  EXPECT_EQ(p.width, 120u);
  EXPECT_EQ(p.scale, 0.5);
  EXPECT_TRUE(p.quiet);
  EXPECT_EQ(p.out, "[b]");
  EXPECT_EQ(p.list, "-");
  EXPECT_EQ(p.title, "--words of any kind");
  EXPECT_EQ(p.files, (std::vector<std::filesystem::path>{"a", "c"}));
}

TEST(OptionSet, RefusesValuesInOneSentence) {
  EXPECT_EQ(refusal({"--colour", "blue"}), "'--colour blue' is not known; choose red|green");
  EXPECT_EQ(refusal({"--width", "5010"}), "'--width 5010' is not valid; give a whole number from 10 to 5,000");
  EXPECT_EQ(refusal({"--width", "15"}), "'--width 15' is not valid; give a multiple of 10 from 10 to 5,000");
  EXPECT_EQ(refusal({"--scale", "inf"}), "'--scale inf' is not valid; give a number from 0.5 to 2");
  EXPECT_EQ(refusal({"--seed"}), "'--seed' needs a value; see 'paint wall --help'");
  EXPECT_EQ(refusal({"--quiet=no"}), "'--quiet' takes no value; leave out what follows its '='");
  EXPECT_EQ(refusal({"--width", "20", "-w", "30"}), "'--width' is given more than once; keep one of them");
  EXPECT_EQ(refusal({"a", "b", "c"}), "'c' is one file too many; give just two");
}

TEST(OptionSet, AppliesRulesAmongOptions) {
  EXPECT_EQ(refusal({"--loud", "--quiet"}), "'--quiet' has no effect with '--loud'; leave out one of the two");
  EXPECT_EQ(refusal({"--list", "--title", "a"}), "'--list' needs '--out OUT'; add it");
  EXPECT_EQ(refusal({"--out", "a"}), "") << "the other way round is no rule";
  EXPECT_EQ(refusal({}, true), "'paint wall' needs '--out OUT' (where it goes); add it");
  EXPECT_EQ(refusal({"--loud", "--quiet", "--width", "1"}),
            "'--width 1' is not valid; give a whole number from 10 to 5,000")
      << "values come first";
}

TEST(OptionSet, HelpHasAHeadingForEachGroup) {
  Painting painting;
  OptionSet options("paint wall", "paint 1");
  painting.declare(options);
  EXPECT_EQ(options.help("Paint."),
            "Paint.\n"
            "Usage: paint wall [OPTIONS] FILE FILE\n"
            "\n"
            "Files:\n"
            "  FILE                        the sketches\n"
            "\n"
            "Options:\n"
            "  -h,--help                   print this help and exit\n"
            "  --version                   print the version and exit\n"
            "  --colour red|green          of the paint (none)\n"
            "  --seed N                    of the brush\n"
            "  -w,--width N                in pixels (10)\n"
            "  --scale X                   of it all (1)\n"
            "  --quiet                     no sound\n"
            "  --out OUT                   where it goes\n"
            "  --list [OUT]                write a list\n"
            "  --title TEXT                its name\n"
            "\n"
            "Sound:\n"
            "  --loud                      much sound\n");
}

}  // namespace
}  // namespace gw::test
