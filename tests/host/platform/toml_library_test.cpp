// What toml++ is kept from: characters outside ASCII where it looks for white space, and assertions about a text.
#include "host/platform/toml_library.h"

#include <gtest/gtest.h>

#include <string>

namespace gw::test {
namespace {

std::string valueOf(const std::string& text, const std::string& key = "a") {
  const toml::table document = parseToml(text);
  return document[key].value_or(std::string("no text under that key"));
}

uint32_t refusedLine(const std::string& text) {
  try {
    parseToml(text);
  } catch (const TomlError& error) {
    EXPECT_STRNE(error.what(), "");
    return error.line;
  }
  return 0;
}

// From every length of UTF-8 and both sides of each border.
const std::string kCharacters[] = {"é",  "ß",      "Ж",      "\u00a0", "\u0499", "\u1680",     "\u2028", "\u2c5e",
                                   "ツ", "\u3000", "\ufeff", "\uff21", "😀",      "\U0010ffff", "\u009f"};

TEST(TomlLibrary, TextsComeOutAsTheyWentIn) {
  for (const std::string& c : kCharacters) {
    EXPECT_EQ(valueOf("a = \"x" + c + "y" + c + "\""), "x" + c + "y" + c);
    EXPECT_EQ(valueOf("a = '" + c + "' # " + c), c);
    EXPECT_EQ(valueOf("a = '''\n" + c + "\n'''"), c + "\n");
    EXPECT_EQ(valueOf("a = \"\"\"b\\\n  " + c + "\"\"\""), "b" + c) << "behind a line that goes on";
    EXPECT_EQ(valueOf("\"" + c + "\" = 'b'", c), "b");
    const toml::table nested = parseToml("[\"" + c + "\"]\nd = [{'" + c + "' = '" + c + "'}]");
    EXPECT_EQ(nested[c]["d"][0][c].value_or(std::string()), c);
    EXPECT_EQ(nested[c].as_table()->source().begin.line, 1u);
  }
  EXPECT_EQ(valueOf("a = \"\\u00e9\\U0001F600\""), "é😀");
  EXPECT_EQ(valueOf("\ufeffa = 'b'"), "b") << "a byte order mark";
}

TEST(TomlLibrary, CharactersOutsideTextsAreRefusedWithTheirLine) {
  for (const std::string& c : kCharacters) {
    EXPECT_EQ(refusedLine("b = 1\na = 1" + c), 2u) << c;
    EXPECT_EQ(refusedLine("b = 1\n" + c + " = 1"), 2u) << c;
    EXPECT_EQ(refusedLine("b = 1\n\na " + c + "= 1"), 3u) << c;
    EXPECT_EQ(refusedLine("a = [1," + c + "2]"), 1u) << c;
    EXPECT_EQ(refusedLine("[a]" + c), 1u) << c;
    EXPECT_EQ(refusedLine("a = \"\\" + c + "\""), 1u) << c;
  }
  EXPECT_EQ(refusedLine("# \u00e9\na = 1\n# \U000f00e9"), 3u) << "a character for private use";
  EXPECT_EQ(refusedLine("\"\u00e9\" = 1\n\"\\u00e9\" = 2"), 1u) << "a key that stands there twice";
}

TEST(TomlLibrary, BytesThatAreNoCharactersAreRefused) {
  for (const char* bytes : {"\xff", "\xc3", "\xc3\x28", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                            "\xf8\x88\x80\x80\x80", "\xe2\x82", "\xf0\x9f\x98"}) {
    EXPECT_EQ(refusedLine(std::string("b = 1\na = '") + bytes + "'"), 2u);
  }
}

TEST(TomlLibrary, MessagesNameTheCharacter) {
  try {
    parseToml("a = 1é");
    FAIL();
  } catch (const TomlError& error) {
    EXPECT_NE(std::string(error.what()).find("é"), std::string::npos) << error.what();
  }
}

// Where toml++ asserts what the text has to prove.
TEST(TomlLibrary, NoTextMeetsAnAssertion) {
  for (const char* text :
       {"[?",    "[",      "[[",     "a.",        "a.?",     "{",    "a = {?", "a = [?",  "?",      "a = 1_",
        "a = +", "a = .1", "a = 0x", "a = 1979-", "a = 07:", "[a.]", "[.a]",   "a = tru", "a = in", "\"a\".? = 1"}) {
    EXPECT_GT(refusedLine(text), 0u) << text;
  }
}

}  // namespace
}  // namespace gw::test
