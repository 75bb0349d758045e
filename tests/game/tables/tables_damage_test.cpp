// Damaged tables: each refusal is one sentence that names file, line and key, and ends in a remedy.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "game/tables/tables.h"

namespace gw::test {
namespace {

enum class File { game, enemies, waves };

struct Damage {
  const char* name;
  File file;
  const char* find;     // its first occurrence...
  const char* replace;  // ...becomes this
  const char* key;      // as the message names it
  const char* says;
  int lineOffset = 0;  // of the named line, counted from the damaged one
};

const Damage kDamages[] = {
    {"NegativeSpeed", File::enemies, "speed_mps = 9\n", "speed_mps = -9\n", "enemy[0].speed_mps", "-9 is out of range"},
    {"ZeroMass", File::enemies, "mass = 1", "mass = 0", "enemy[0].mass", "out of range"},
    {"InfiniteSight", File::enemies, "sight_m = 30", "sight_m = inf", "enemy[0].sight_m", "inf is out of range"},
    {"NotANumber", File::enemies, "energy = 1", "energy = nan", "enemy[0].energy", "nan is out of range"},
    {"TextForNumber", File::enemies, "energy = 3", "energy = \"3\"", "enemy[1].energy", "'3' is not a number"},
    {"NumberForText", File::enemies, "name = \"quad\"", "name = 4", "enemy[1].name", "4 is not a text"},
    {"FractionForWhole", File::enemies, "value = 25", "value = 25.5", "enemy[1].value", "25.5 is not a whole number"},
    {"DateForNumber", File::enemies, "value = 25", "value = 2024-01-01", "enemy[1].value", "a date or time is not"},
    {"ListForNumber", File::enemies, "value = 25", "value = [25]", "enemy[1].value", "a list is not a whole number"},
    {"MissingKey", File::enemies, "bits = 6", "", "enemy[2].bits", "the key is missing", -12},
    {"UnknownKey", File::enemies, "bits = 6", "bits = 6\nbites = 1", "enemy[2].bites", "not known; remove it", 1},
    {"KeyTwice", File::enemies, "bits = 6", "bits = 6\nbits = 7", "", "not TOML", 1},
    {"UnknownMachine", File::enemies, "\"kamikaze\"", "\"banzai\"", "enemy[0].machine", "choose one of: kamikaze"},
    {"NoSpeed", File::enemies, "speed_mps = 9\n", "", "enemy[0].speed_mps", "the key is missing", -5},
    {"GroupWithoutCooldown", File::enemies, "\"kamikaze\"", "\"group\"", "enemy[0].avoid_cooldown_ticks", "missing",
     -2},
    {"KamikazeWithCooldown", File::enemies, "bits = 6", "bits = 6\navoid_cooldown_ticks = 9",
     "enemy[2].avoid_cooldown_ticks", "not known", 1},
    {"NegativeCooldown", File::enemies, "avoid_cooldown_ticks = 240", "avoid_cooldown_ticks = -1",
     "enemy[3].avoid_cooldown_ticks", "-1 is out of range"},
    {"UnknownBounds", File::enemies, "\"rectangle\"", "\"oval\"", "enemy[1].bounds",
     "choose one of: circle, rectangle"},
    {"UnknownShape", File::enemies, "\"square\"", "\"blob\"", "enemy[1].shape", "'blob' is not known"},
    {"RadiusOfRectangle", File::enemies, "width_m = 1.1", "radius_m = 1.1", "enemy[1].width_m", "missing", -4},
    {"NameTwice", File::enemies, "\"quad\"", "\"triangle\"", "enemy[1].name", "stands in the table twice"},
    {"NameTooLong", File::enemies, "\"quad\"", "\"quadrilateral_xx\"", "enemy[1].name", "is not a name"},
    {"NameEmpty", File::enemies, "\"quad\"", "\"\"", "enemy[1].name", "is not a name"},
    {"NameWithSpace", File::enemies, "\"quad\"", "\"a b\"", "enemy[1].name", "is not a name"},
    {"NameWithLineEnd", File::enemies, "\"quad\"", "\"a\\nb\"", "enemy[1].name", "'a?b' is not a name"},
    {"KeyWithLineEnd", File::enemies, "bits = 6", "bits = 6\n\"a\\nb\" = 1", "enemy[2].a?b", "not known", 1},
    {"ColourTooLarge", File::enemies, "0xffb000", "0x1ffb000", "enemy[0].colour", "out of range"},
    {"ShortSight", File::enemies, "vision_m = 4\nenergy = 16", "vision_m = 2\nenergy = 16", "enemy[2].vision_m",
     "give at least 2.40"},
    {"BrokenString", File::enemies, "\"quad\"", "\"quad", "", "not TOML"},
    {"UnclosedTable", File::game, "[ship]", "[ship", "", "not TOML"},
    {"MissingTable", File::game, "[bit]", "[byte]", "bit", "the key is missing", 999},
    {"UnknownTable", File::game, "[bit]", "[extra]\n[bit]", "extra", "not known"},
    {"TableAsNumber", File::game, "[world]", "ship = 1\n[world]", "", "not TOML", 999},
    {"ResponseTooLarge", File::game, "response = 0.3", "response = 1.5", "ship.response", "from 0.01 to 1"},
    {"NegativeTicks", File::game, "life_ticks = 48", "life_ticks = -1", "shot.life_ticks", "-1 is out of range"},
    {"HugeInteger", File::game, "life_ticks = 48", "life_ticks = 5000000000", "shot.life_ticks", "out of range"},
    {"LimitBelowStart", File::game, "83333", "16667", "budget.limit_us", "not above start_us"},
    {"FirstLevelLate", File::game, "from_tenths = 10", "from_tenths = 11", "shot.level[0].from_tenths", "write 10"},
    {"LevelsOutOfOrder", File::game, "from_tenths = 300", "from_tenths = 100", "shot.level[3].from_tenths",
     "order levels upwards"},
    {"TakenBeyondReach", File::game, "take_m = 1", "take_m = 6", "bit.take_m", "beyond attract_m"},
    {"FewerThanAtStart", File::game, "most = 5", "most = 2", "flush.most", "below start"},
    {"ScoresOutOfOrder", File::game, "100_000, 300_000", "300_000, 100_000", "flush.scores", "order the numbers", -1},
    {"ScoreAsText", File::game, "100_000, 300_000", "\"much\", 300_000", "flush.scores", "'much' does not belong", -1},
    {"TooManyScores", File::game, "100_000, 300_000", "1, 2, 3", "flush.scores", "keep at most 16", -1},
    {"EndlessTooEarly", File::game, "from_s = 180", "from_s = 166", "endless.from_s", "after the last wave"},
    {"ChancesNotHundred", File::game, "triangle = 30", "triangle = 29", "endless.chance_percent", "add up to 99", -1},
    {"PriceOfUnknownType", File::game, "quad = 2", "quad = 2\ntorus = 2", "endless.price.torus", "not known", 1},
    {"PriceMissing", File::game, "quad = 2", "", "endless.price.quad", "missing", -2},
    {"UnknownType", File::waves, "type = \"quad\"", "type = \"torus\"", "wave[4].groups[0].type",
     "choose one of: triangle, quad, hexagon"},
    {"CountNotANumber", File::waves, "count = 24", "count = nan", "wave[0].groups[0].count", "nan is not a whole"},
    {"NegativeCount", File::waves, "count = 24", "count = -24", "wave[0].groups[0].count", "-24 is out of range"},
    {"RecoversBelowEscape", File::game, "recovered_at = 0.9", "recovered_at = 0.4", "steering.recovered_at",
     "not above escape_below"},
    {"AvoidsTooFast", File::game, "avoid_mps = 15", "avoid_mps = 19", "steering.avoid_mps", "from 0 to 18"},
    {"PressesForNothing", File::game, "press_mps = 4", "press_mps = 0", "steering.press_mps", "0 is out of range"},
    {"NoPress", File::game, "press_mps = 4", "", "steering.press_mps", "the key is missing", -7},
    {"PaceFalls", File::game, "pace_growth = 1.035", "pace_growth = 0.9", "endless.pace_growth", "from 1 to 2"},
    {"PaceIsNoNumber", File::game, "pace_most = 2", "pace_most = nan", "endless.pace_most", "nan is out of range"},
    {"NoClock", File::game, "clock_s = 180", "clock_s = 0", "deadline.clock_s", "0 is out of range"},
    {"NoWaveRate", File::game, "wave_rate = 2", "wave_rate = 0", "deadline.wave_rate", "0 is out of range"},
    {"SwarmTooClear", File::game, "clearance_m = 30          # of the ship", "clearance_m = 31", "swarm.clearance_m",
     "31 is out of range"},
    {"UnknownPattern", File::waves, "\"spiral\"", "\"knot\"", "wave[1].groups[0].pattern", "choose one of: ring"},
    {"EmptyGroup", File::waves, "count = 24", "count = 0", "wave[0].groups[0].count", "0 is out of range"},
    {"HugeGroup", File::waves, "count = 24", "count = 100001", "wave[0].groups[0].count", "out of range"},
    {"WavesOutOfOrder", File::waves, "at_s = 14", "at_s = 7", "wave[2].at_s", "order waves by time"},
    {"WaveAtFraction", File::waves, "at_s = 14", "at_s = 14.5", "wave[2].at_s", "not a whole number"},
    {"TooManyGroups", File::waves, "groups = [", "groups = [{}, {}, {}, {},", "wave[0].groups", "keep at most 4"},
    {"NoGroups", File::waves, "{count = 24, type = \"triangle\", pattern = \"ring\"},", "", "wave[0].groups",
     "not a list of tables", -1},
    {"ControlCharacter", File::waves, "at_s = 14", "at_s = 1\x01", "", "not TOML"},
    {"BadEncoding", File::waves, "at_s = 14", "# \xff\xfe", "", "not TOML"},
};

RuleTexts assets() {
  RuleTexts texts = readRuleTexts(GW_ASSETS_DIR);
  texts.game.name = "game.toml";
  texts.enemies.name = "enemies.toml";
  texts.waves.name = "waves.toml";
  return texts;
}

RuleText& textOf(RuleTexts& texts, File file) {
  return file == File::game ? texts.game : file == File::enemies ? texts.enemies : texts.waves;
}

std::string refusalOf(const RuleTexts& texts) {
  try {
    loadRules(texts);
    return "";
  } catch (const TableError& error) {
    return error.what();
  }
}

class TableDamage : public ::testing::TestWithParam<Damage> {};

TEST_P(TableDamage, IsRefusedWithFileLineKeyAndRemedy) {
  const Damage& damage = GetParam();
  RuleTexts texts = assets();
  RuleText& text = textOf(texts, damage.file);
  const size_t at = text.text.find(damage.find);
  ASSERT_NE(at, std::string::npos);
  const auto line = std::count(text.text.begin(), text.text.begin() + ptrdiff_t(at), '\n') + 1 + damage.lineOffset;
  text.text.replace(at, std::string(damage.find).size(), damage.replace);

  const std::string said = refusalOf(texts);
  const std::string key = *damage.key ? fmt::format(", {}: ", damage.key) : ": ";
  const std::string start = damage.lineOffset == 999 ? fmt::format("{}, line ", text.name)
                                                     : fmt::format("{}, line {}{}", text.name, line, key);
  EXPECT_EQ(said.rfind(start, 0), 0u) << said << "\nexpected: " << start;
  EXPECT_NE(said.find(key), std::string::npos) << said;
  EXPECT_NE(said.find(damage.says), std::string::npos) << said;
  EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << "not one sentence: " << said;
}

INSTANTIATE_TEST_SUITE_P(Each, TableDamage, ::testing::ValuesIn(kDamages),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TableLimits, TooManyTypes) {
  RuleTexts texts = assets();
  for (uint32_t i = 0; i < 1000; ++i) texts.enemies.text += "\n[[enemy]]\nname = \"more\"\n";
  EXPECT_NE(refusalOf(texts).find("enemy: there are 1007 of them; keep at most 8"), std::string::npos)
      << refusalOf(texts);
}

TEST(TableLimits, TooManyWaves) {
  RuleTexts texts = assets();
  for (uint32_t i = 0; i < kMaxWaves; ++i) texts.waves.text += "\n[[wave]]\n";
  EXPECT_NE(refusalOf(texts).find("keep at most 64"), std::string::npos) << refusalOf(texts);
}

TEST(TableLimits, TooManyShotLevels) {
  RuleTexts texts = assets();
  const size_t at = texts.game.text.find("[bit]");
  for (uint32_t i = 0; i < kMaxShotLevels; ++i) texts.game.text.insert(at, "[[shot.level]]\n");
  EXPECT_NE(refusalOf(texts).find("shot.level: there are 13"), std::string::npos) << refusalOf(texts);
}

TEST(TableLimits, EmptyTexts) {
  for (File file : {File::game, File::enemies, File::waves}) {
    RuleTexts texts = assets();
    textOf(texts, file).text.clear();
    EXPECT_NE(refusalOf(texts).find("line 1, "), std::string::npos) << refusalOf(texts);
    EXPECT_NE(refusalOf(texts).find("the key is missing"), std::string::npos) << refusalOf(texts);
  }
}

TEST(TableLimits, LongTextsAndLines) {
  RuleTexts texts = assets();
  texts.game.text += "\n# " + std::string(300, 'x');
  EXPECT_NE(refusalOf(texts).find("longer than 200 characters; break it"), std::string::npos) << refusalOf(texts);
  texts.game.text.assign(kMaxRuleText + 1, '\n');
  EXPECT_NE(refusalOf(texts).find("longer than 262144 bytes"), std::string::npos) << refusalOf(texts);
}

TEST(TableLimits, LongQuotesAreShortened) {
  RuleTexts texts = assets();
  std::string name;
  for (int i = 0; i < 500; ++i) name += std::string(190, 'x') + "\n";
  texts.enemies.text.replace(texts.enemies.text.find("\"quad\""), 6, "\"\"\"" + name + "\"\"\"");
  EXPECT_NE(refusalOf(texts).find("xxx ... "), std::string::npos);
  EXPECT_LT(refusalOf(texts).size(), 700u);
}

// What would need a stack frame per level if it were allowed to nest.
TEST(TableLimits, DeepNestingIsRefused) {
  for (const char* piece : {"[", "{a=", "[{a.b.c.d.e.f.g.h=\n"}) {
    RuleTexts texts = assets();
    texts.game.text = "a=";
    for (int i = 0; i < 30; ++i) texts.game.text += piece;
    EXPECT_NE(refusalOf(texts).find("not TOML"), std::string::npos) << refusalOf(texts);
  }
}

TEST(TableFiles, MissingFilesAreNamed) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "gw_no_assets_here";
  try {
    readRuleTexts(folder);
    FAIL();
  } catch (const TableError& error) {
    EXPECT_EQ(error.what(), (folder / "game.toml").string() +
                                ": there is no such file; reinstall the game or name the folder with --assets");
  }
}

TEST(TableFiles, LongFilesAreRefused) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "gw_long_assets";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "game.toml") << std::string(kMaxRuleText + 1, '\n');
  EXPECT_THROW(readRuleTexts(folder), TableError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gw::test
