// Keys by name: in the settings file the same for every layout and every SDL, on the screens as they are printed.
#include "host/input/key_labels.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <map>

#include "host/input/control_names.h"
#include "host/input/key_names.h"

namespace gw {
namespace {

// A layout by what it has elsewhere than a US keyboard. "" is a dead key.
KeyLayout layout(const std::map<uint16_t, std::string>& changes) {
  return [changes](uint16_t code) {
    const auto found = changes.find(code);
    return found == changes.end() ? std::string(keyName(code)) : found->second;
  };
}

const KeyLayout kFrench = layout({{SDL_SCANCODE_Q, "A"},
                                  {SDL_SCANCODE_A, "Q"},
                                  {SDL_SCANCODE_W, "Z"},
                                  {SDL_SCANCODE_Z, "W"},
                                  {SDL_SCANCODE_SEMICOLON, "M"},
                                  {SDL_SCANCODE_M, ","},
                                  {SDL_SCANCODE_COMMA, ";"},
                                  {SDL_SCANCODE_PERIOD, ":"},
                                  {SDL_SCANCODE_SLASH, "!"},
                                  {SDL_SCANCODE_MINUS, ")"},
                                  {SDL_SCANCODE_LEFTBRACKET, ""},
                                  {SDL_SCANCODE_RIGHTBRACKET, "$"},
                                  {SDL_SCANCODE_APOSTROPHE, "ù"},
                                  {SDL_SCANCODE_GRAVE, "²"}});
const KeyLayout kGerman = layout({{SDL_SCANCODE_Y, "Z"},
                                  {SDL_SCANCODE_Z, "Y"},
                                  {SDL_SCANCODE_MINUS, "ß"},
                                  {SDL_SCANCODE_EQUALS, ""},
                                  {SDL_SCANCODE_RIGHTBRACKET, "+"},
                                  {SDL_SCANCODE_SLASH, "-"},
                                  {SDL_SCANCODE_SEMICOLON, "ö"},
                                  {SDL_SCANCODE_NONUSBACKSLASH, "<"}});
const KeyLayout kRussian = layout({{SDL_SCANCODE_Q, "й"}, {SDL_SCANCODE_C, "с"}, {SDL_SCANCODE_COMMA, "б"}});
const KeyLayout kTurkish = layout({{SDL_SCANCODE_I, "ı"}, {SDL_SCANCODE_APOSTROPHE, "I"}});

TEST(KeyLabels, AreWhatIsPrintedOnTheKey) {
  EXPECT_EQ(keyLabel(SDL_SCANCODE_Q, kFrench), "A");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_W, kFrench), "Z");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_M, kFrench), ",");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_O, kFrench), "O");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_LSHIFT, kFrench), "Left Shift");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_NONUSBACKSLASH, kGerman), "<");
}

TEST(KeyLabels, LettersOfOtherScriptsGoByTheLatinOneBesideThem) {
  EXPECT_EQ(keyLabel(SDL_SCANCODE_Q, kRussian), "Q");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_C, kRussian), "C");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_I, kTurkish), "US I") << "another key is called I there";
}

TEST(KeyLabels, WhatTheTypefaceLacksIsAPlaceOnAUsKeyboard) {
  EXPECT_EQ(keyLabel(SDL_SCANCODE_MINUS, kGerman), "US -") << "the key called - is another one";
  EXPECT_EQ(keyLabel(SDL_SCANCODE_EQUALS, kGerman), "US =") << "a dead key";
  EXPECT_EQ(keyLabel(SDL_SCANCODE_APOSTROPHE, kFrench), "US '");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_COMMA, kRussian), "US ,");
  EXPECT_EQ(keyLabel(SDL_SCANCODE_INTERNATIONAL1, layout({})), "Key 135");
}

TEST(KeyLabels, PlusAndMinusAreFoundWhereverTheyAre) {
  EXPECT_TRUE(layoutHas('+', kGerman) && layoutHas('-', kGerman));
  EXPECT_FALSE(layoutHas('+', kFrench) || layoutHas('-', kFrench));
}

TEST(KeyLabels, NoTwoKeysOfALayoutShareOne) {
  for (const KeyLayout& each : {kFrench, kGerman, kRussian, kTurkish}) {
    std::map<std::string, uint16_t> seen;
    for (uint16_t code = SDL_SCANCODE_A; code <= SDL_SCANCODE_SLASH; ++code) {
      const auto [other, fresh] = seen.emplace(keyLabel(code, each), code);
      EXPECT_TRUE(fresh) << other->first << " is " << code << " and " << other->second;
    }
  }
}

TEST(KeyNames, MeanTheSameToSdl) {
  int named = 0;
  for (uint16_t code = 1; code < 256; ++code) {  // the ones of media keys differ from version to version
    if (keyName(code).empty()) continue;
    ++named;
    EXPECT_EQ(SDL_GetScancodeFromName(std::string(keyName(code)).c_str()), SDL_Scancode(code)) << keyName(code);
  }
  EXPECT_EQ(named, 192);
}

// On Debian 12 key 100 goes by its number, on Debian 14 SDL calls it NonUSBackslash: a file of either is one for both.
TEST(KeyNames, WhatOnlyLaterVersionsNameIsWrittenAsANumberAndUnderstoodByName) {
  const std::map<uint16_t, std::string> later = {{100, "NonUSBackslash"},
                                                 {135, "International 1"},
                                                 {143, "International 9"},
                                                 {144, "Language 1"},
                                                 {152, "Language 9"}};
  for (const auto& [code, name] : later) {
    const Control control{InputDevice::keyboard, code};
    EXPECT_EQ(controlName(control), "Key " + std::to_string(code));
    EXPECT_EQ(controlFromName(InputDevice::keyboard, name), control) << name;
    EXPECT_EQ(controlFromName(InputDevice::keyboard, "Key " + std::to_string(code)), control);
  }
  EXPECT_EQ(controlFromName(InputDevice::keyboard, "Language 10"), std::nullopt);
  EXPECT_EQ(controlName({InputDevice::keyboard, 158}), "Key 158") << "Return is key 40";
}

}  // namespace
}  // namespace gw
