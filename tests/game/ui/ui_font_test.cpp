// The typeface that the screens are written in, and the message for a damaged one.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "render/text_font.h"

namespace gw {
namespace {

namespace fs = std::filesystem;

class UiFontTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder / "fonts");
    for (const char* name : {"fonts/neon.json", "fonts/neon.png"}) {
      fs::copy_file(fs::path(GW_ASSETS_DIR) / name, folder / name, fs::copy_options::overwrite_existing);
    }
  }
  void TearDown() override { fs::remove_all(folder); }

  void write(const char* name, const std::string& text) { std::ofstream(folder / name, std::ios::binary) << text; }

  // The sentence; empty when the font loads.
  std::string complaint() const {
    try {
      loadTextFont(folder);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder;
};

TEST_F(UiFontTest, HoldsEveryPrintableCharacter) {
  const TextFont font = loadTextFont(folder);
  for (char character = '!'; character <= '~'; ++character) {
    EXPECT_GT(font.glyph(character).width, 0) << character;
    EXPECT_GT(font.glyph(character).advance, 0) << character;
  }
  EXPECT_EQ(font.glyph(' ').width, 0);
  EXPECT_EQ(&font.glyph('\n'), &font.glyph('?'));
  EXPECT_EQ(&font.glyph(char(0xc3)), &font.glyph('?'));
}

TEST_F(UiFontTest, DigitsAdvanceAlikeAndWidthsScale) {
  const TextFont font = loadTextFont(folder);
  for (char digit = '0'; digit <= '9'; ++digit) EXPECT_EQ(font.glyph(digit).advance, font.glyph('0').advance);
  EXPECT_EQ(font.width_px("", 20), 0);
  EXPECT_FLOAT_EQ(font.width_px("GPUWARS", 40), 2 * font.width_px("GPUWARS", 20));
  EXPECT_GT(font.width_px("AB", 20), font.width_px("A", 20));
}

TEST_F(UiFontTest, ADamagedOrMissingFileIsNamedWithARemedy) {
  write("fonts/neon.png", "not a picture");
  EXPECT_NE(complaint().find("neon.png"), std::string::npos) << complaint();
  EXPECT_NE(complaint().find("make_font.py"), std::string::npos) << complaint();

  fs::remove(folder / "fonts/neon.png");
  EXPECT_NE(complaint().find("neon.png"), std::string::npos) << complaint();

  for (const char* text : {"", "[]", "{", "{\"pixelsPerUnit\": \"many\"}", "{\"pixelsPerUnit\": -1}"}) {
    write("fonts/neon.json", text);
    EXPECT_NE(complaint().find("neon.json"), std::string::npos) << text << ": " << complaint();
    EXPECT_EQ(complaint().find('\n'), std::string::npos) << text;
  }
}

TEST_F(UiFontTest, AGlyphOutsideTheAtlasIsRefused) {
  std::ifstream file(folder / "fonts/neon.json");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const size_t at = text.find("\"65\": [") + 7;
  text.replace(at, text.find(',', at) - at, "99999");
  write("fonts/neon.json", text);
  EXPECT_NE(complaint().find("glyph 65"), std::string::npos) << complaint();
}

}  // namespace
}  // namespace gw
