// Verbs of a program that is no game: which one runs, what belongs to which, and the texts made from the table.
#include "host/cli/verb_parser.h"

#include <gtest/gtest.h>

#include "host/cli/bash_completion.h"
#include "host/cli/man_page.h"

namespace gw::test {
namespace {

struct Painter {
  bool wet = false;
  uint32_t coats = 1;
  std::vector<Verb> verbs = {
      {"paint", "Paint a wall.",
       [this](OptionSet& options) { options.integer("--coats", "how many (1)", 1, 9, coats, "Advanced"); },
       [this] {
         if (coats == 7) throw UsageError("'--coats 7' is unlucky; choose another number");
       }},
      {"wash", "Wash it.", [this](OptionSet& options) { options.flag("--wet", "with water", wet); }, [] {}},
  };
  ProgramText program = {.name = "painter",
                         .version = "painter 2",
                         .title = "Painter",
                         .summary = "walls in colours",
                         .verbHint = "to dry one: wait",
                         .filePattern = "*.wall",
                         .paragraphs = {"It paints."},
                         .files = {{"~/.paint", "The paint."}},
                         .environment = {{"BRUSH", "Which one."}},
                         .exitCodes = {{"0", "success"}, {"2", "bad usage"}}};

  ParsedVerb parse(std::vector<std::string> arguments) { return parseVerb(program, verbs, std::move(arguments)); }
  std::string error(std::vector<std::string> arguments) {
    const ParsedVerb parsed = parse(std::move(arguments));
    EXPECT_FALSE(parsed.run);
    EXPECT_EQ(parsed.code, ExitCode::badUsage);
    return parsed.error;
  }
};

TEST(VerbParser, RunsTheVerbThatIsNamedElseTheFirst) {
  Painter painter;
  const ParsedVerb wash = painter.parse({"wash", "--wet"});
  EXPECT_TRUE(wash.run && painter.wet);
  EXPECT_EQ(wash.verb, 1u);
  const ParsedVerb paint = painter.parse({"--coats", "3"});
  EXPECT_TRUE(paint.run);
  EXPECT_EQ(paint.verb, 0u);
  EXPECT_EQ(painter.coats, 3u);
  EXPECT_TRUE(painter.parse({}).run);
}

TEST(VerbParser, RefusesWithARemedy) {
  Painter painter;
  EXPECT_EQ(painter.error({"dry"}), "'dry' is not a verb; choose paint or wash (to dry one: wait)");
  EXPECT_EQ(painter.error({"paint", "--wet"}),
            "'--wet' belongs to 'painter wash', not to 'painter paint'; leave it out");
  EXPECT_EQ(painter.error({"wash", "--dry=1"}), "'--dry' is not an option; see 'painter wash --help'");
  EXPECT_EQ(painter.error({"wash", "a"}), "'a' is not understood; 'painter wash' takes options only");
  EXPECT_EQ(painter.error({"--coats", "7"}), "'--coats 7' is unlucky; choose another number");
  EXPECT_EQ(painter.error({"a\nb"}).find('\n'), std::string::npos);
}

TEST(VerbParser, HelpListsTheVerbsAndExitCodes) {
  Painter painter;
  EXPECT_EQ(painter.parse({"--help"}).output,
            "Painter: walls in colours.\n\nUsage: painter [VERB] [OPTIONS]\n\nVerbs:\n"
            "  paint    Paint a wall.\n  wash     Wash it.\n\n"
            "'painter VERB --help' lists a verb's options; they mean the same under every verb.\n"
            "Exit codes: 0 success, 2 bad usage.\n");
  EXPECT_EQ(painter.parse({"wash", "--version"}).output, "painter 2\n");
  EXPECT_EQ(painter.parse({"wash", "-h"}).output.substr(0, 9), "Wash it.\n");
}

TEST(VerbParser, OneTableMakesPagesAndCompletion) {
  Painter painter;
  const std::vector<VerbText> verbs = describe(painter.program, painter.verbs);
  ASSERT_EQ(verbs.size(), 2u);
  const std::string main = mainPage(painter.program, verbs, {"2", "2026-01-01"});
  for (const char* part :
       {".TH PAINTER 6 \"2026-01-01\" \"painter 2\" Games\n", "painter \\- walls in colours\n", "It paints.\n",
        ".I \\(ti/.paint\nThe paint.\n", ".B BRUSH\nWhich one.\n", ".B 2\nbad usage\n", ".BR painter\\-wash (6)\n"}) {
    EXPECT_NE(main.find(part), std::string::npos) << part << "\n" << main;
  }
  const std::string paint = verbPage(painter.program, verbs[0], {"2", "2026-01-01"});
  EXPECT_NE(paint.find(".SS Advanced\n.TP\n\\fB\\-\\-coats\\fR \\fIN\\fR\nhow many (1)\n"), std::string::npos) << paint;
  const std::string script = bashCompletion(painter.program, verbs);
  EXPECT_NE(script.find("complete -F _painter painter\n"), std::string::npos) << script;
  EXPECT_NE(script.find("'!*.wall'"), std::string::npos) << script;
  EXPECT_NE(script.find("*) verb=paint ;;"), std::string::npos) << script;
  EXPECT_EQ(script.find('@'), std::string::npos) << script;
}

TEST(VerbParser, JoinsArgumentsAsAShellTakesThem) {
  EXPECT_EQ(joined({"play", "--record", "my run", "", "a$b"}), "play --record 'my run' '' 'a$b'");
}

}  // namespace
}  // namespace gw::test
