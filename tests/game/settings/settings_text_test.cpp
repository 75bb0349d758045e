// Settings as text: what is written is read back, and what is wrong costs itself only.
#include "game/settings/settings_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "game/settings/settings_fields.h"
#include "host/input/control_names.h"
#include "tests/game/settings/settings_samples.h"

namespace gw::test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string lineNumber(const std::string& text, const std::string& part) {
  const size_t at = text.find(part);
  return "line " + std::to_string(1 + std::count(text.begin(), text.begin() + long(std::min(at, text.size())), '\n'));
}

TEST(SettingsText, WhatIsWrittenIsReadBack) {
  for (const Settings& settings : {Settings(), otherSettings()}) {
    const ReadSettings read = readSettings(writeSettings(settings), "s");
    EXPECT_EQ(read.settings, settings);
    EXPECT_TRUE(read.complaints.empty());
    EXPECT_FALSE(read.damaged);
  }
}

RC_GTEST_PROP(SettingsText, AnySettingsAreReadBack, ()) {
  Settings settings;
  for (const SettingsField& field : settingsFields()) {
    if (field.flag) {
      *field.flag(settings) = *rc::gen::arbitrary<bool>();
    } else {
      *field.number(settings) = field.most * float(*rc::gen::inRange(0, 1 << 24)) / float(1 << 24);
    }
  }
  for (uint32_t device = 0; device < kInputDevices; ++device) {
    const int first = device == uint32_t(InputDevice::pad) ? 0 : 1;
    const int end = std::array<int, 3>{kKeys, kMouseButtons, kPadButtons}[device];
    for (auto& codes : settings.bindings.of[device]) {
      codes.clear();
      for (int i = *rc::gen::inRange<int>(0, kMaxControls + 1); i > 0; --i) {
        const auto code = uint16_t(*rc::gen::inRange(first, end));
        const bool fixed = device == uint32_t(InputDevice::keyboard) && isInstrumentKey(code);
        if (!fixed && std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(code);
      }
    }
  }
  const ReadSettings read = readSettings(writeSettings(settings), "s");
  RC_ASSERT(read.settings == settings);
  RC_ASSERT(read.complaints.empty());
}

TEST(SettingsText, EveryControlHasANameThatGivesItBack) {
  const auto check = [](InputDevice device, uint32_t first, uint32_t end) {
    std::set<std::string> names;
    for (uint32_t code = first; code < end; ++code) {
      const Control control{device, uint16_t(code)};
      EXPECT_EQ(controlFromName(device, controlName(control)), control) << controlName(control);
      EXPECT_TRUE(names.insert(controlName(control)).second) << controlName(control);
      EXPECT_FALSE(controlLabel(control).empty());
    }
  };
  check(InputDevice::keyboard, 1, kKeys);
  check(InputDevice::mouse, 1, kMouseButtons);
  check(InputDevice::pad, 0, kPadButtons);
  EXPECT_EQ(controlFromName(InputDevice::keyboard, "left SHIFT"), (Control{InputDevice::keyboard, 225}));
  EXPECT_EQ(controlFromName(InputDevice::pad, "lefttrigger"), (Control{InputDevice::pad, kPadLeftTrigger}));
  EXPECT_EQ(controlFromName(InputDevice::keyboard, ""), std::nullopt);
  EXPECT_EQ(controlFromName(InputDevice::keyboard, "Key 0"), std::nullopt);
  EXPECT_EQ(controlFromName(InputDevice::keyboard, "Key 4"), std::nullopt) << "it is A, and called so";
  EXPECT_EQ(controlFromName(InputDevice::mouse, "leftshoulder"), std::nullopt);
}

// One thing wrong in a file where nothing has its default: that one value has it, and all else stays.
struct Damage {
  const char* name;
  std::string from, to;  // in the text of otherSettings()
  std::vector<std::string> says;
  std::function<void(Settings&)> costs;
};

const Settings kDefaults;

void useDefault(Settings& settings, InputDevice device, Action action) {
  settings.bindings.codes(device, action) = kDefaults.bindings.codes(device, action);
}

const Damage kDamages[] = {
    {"a text for a number",
     "effects = 0.35",
     "effects = \"loud\"",
     {"sound.effects", "loud", "0.8 is used"},
     [](Settings& s) { s.sound.effects = 0.8f; }},
    {"too large",
     "music = 0.1",
     "music = 1.5",
     {"sound.music", "1.5", "0 to 1"},
     [](Settings& s) { s.sound.music = 0.6f; }},
    {"below zero", "music = 0.1", "music = -0.1", {"sound.music", "-0.1"}, [](Settings& s) { s.sound.music = 0.6f; }},
    {"not a number", "shake = 0.5", "shake = nan", {"effects.shake", "nan"}, [](Settings& s) { s.effects.shake = 1; }},
    {"infinite", "shake = 0.5", "shake = inf", {"effects.shake", "inf"}, [](Settings& s) { s.effects.shake = 1; }},
    {"minus infinite", "flash = 0", "flash = -inf", {"effects.flash"}, [](Settings& s) { s.effects.flash = 1; }},
    {"huge", "flash = 0", "flash = 1e300", {"effects.flash"}, [](Settings& s) { s.effects.flash = 1; }},
    {"a number for a switch",
     "muted = true",
     "muted = 1",
     {"sound.muted", "true or false", "false is used"},
     [](Settings& s) { s.sound.muted = false; }},
    {"a text for a switch",
     "particles = false",
     "particles = \"false\"",
     {"effects.particles"},
     [](Settings& s) { s.effects.particles = true; }},
    {"a dead zone that leaves no stick",
     "aim_dead_zone = 0.9",
     "aim_dead_zone = 1.0",
     {"pad.aim_dead_zone", "0.9"},
     [](Settings& s) { s.pad.aimDeadZone = 0.25f; }},
    {"a list for a number",
     "move_dead_zone = 0.45",
     "move_dead_zone = [0.1]",
     {"pad.move_dead_zone"},
     [](Settings& s) { s.pad.moveDeadZone = 0.2f; }},
    {"a table for a number",
     "move_dead_zone = 0.45",
     "move_dead_zone = { a = 1 }",
     {"pad.move_dead_zone"},
     [](Settings& s) { s.pad.moveDeadZone = 0.2f; }},
    {"a date for a switch",
     "[video]\nfullscreen = true",
     "[video]\nfullscreen = 1979-05-27",
     {"video.fullscreen"},
     [](Settings& s) { s.video.fullscreen = false; }},
    {"a number for keys",
     "move_up = [\"B\", \"C\"]",
     "move_up = 4",
     {"keys.move_up", "list"},
     [](Settings& s) { useDefault(s, InputDevice::keyboard, Action::moveUp); }},
    {"a text for keys",
     "move_up = [\"B\", \"C\"]",
     "move_up = \"B\"",
     {"keys.move_up", "brackets"},
     [](Settings& s) { useDefault(s, InputDevice::keyboard, Action::moveUp); }},
    {"one unknown key of two",
     "move_up = [\"B\", \"C\"]",
     "move_up = [\"B\", \"Bogus\"]",
     {"keys.move_up", "Bogus"},
     [](Settings& s) { s.bindings.codes(InputDevice::keyboard, Action::moveUp) = {5}; }},
    {"a number among keys",
     "move_up = [\"B\", \"C\"]",
     "move_up = [7, \"C\"]",
     {"keys.move_up", "7"},
     [](Settings& s) { s.bindings.codes(InputDevice::keyboard, Action::moveUp) = {6}; }},
    {"a key twice",
     "move_up = [\"B\", \"C\"]",
     "move_up = [\"B\", \"b\", \"C\"]",
     {"keys.move_up", "twice"},
     [](Settings&) {}},
    {"a key of the instruments",
     "move_up = [\"B\", \"C\"]",
     "move_up = [\"B\", \"F4\", \"C\"]",
     {"keys.move_up", "F4"},
     [](Settings&) {}},
    {"nine keys",
     "move_up = [\"B\", \"C\"]",
     R"(move_up = ["B", "C", "D", "E", "F", "G", "H", "I", "J"])",
     {"keys.move_up", "'J'", "8"},
     [](Settings& s) { s.bindings.codes(InputDevice::keyboard, Action::moveUp) = {5, 6, 7, 8, 9, 10, 11, 12}; }},
    {"an unknown mouse button",
     "[mouse]\nmove_up = [\"middle\", \"x2\"]",
     "[mouse]\nmove_up = [\"thumb\", \"x2\"]",
     {"mouse.move_up", "thumb", "mouse button"},
     [](Settings& s) { s.bindings.codes(InputDevice::mouse, Action::moveUp) = {5}; }},
    {"a key for a pad button",
     "[pad_buttons]\nmove_up = [\"guide\", \"start\"]",
     "[pad_buttons]\nmove_up = [\"Space\", \"start\"]",
     {"pad_buttons.move_up", "Space", "pad button"},
     [](Settings& s) { s.bindings.codes(InputDevice::pad, Action::moveUp) = {6}; }},
    {"an unknown key",
     "muted = true",
     "muted = true\nloudness = 11",
     {"sound.loudness", "not known"},
     [](Settings&) {}},
    {"an unknown action", "[mouse]", "dance = [\"D\"]\n[mouse]", {"keys.dance", "not known"}, [](Settings&) {}},
    {"an unknown section", "[video]", "[smell]\nroses = 1\n[video]", {"smell", "not known"}, [](Settings&) {}},
    {"an unknown value before all sections",
     "# GpuWars",
     "version = 2\n# GpuWars",
     {"version", "not known"},
     [](Settings&) {}},
    {"a section that is not there",
     "[video]\nfullscreen = true\nkeep_pointer = false\n",
     "",
     {},
     [](Settings& s) { s.video.fullscreen = false, s.video.keepPointer = true; }},
    {"control characters in a value",
     "effects = 0.35",
     "effects = \"a\\u0007\\nb\"",
     {"sound.effects"},
     [](Settings& s) { s.sound.effects = 0.8f; }},
};

TEST(SettingsText, OneWrongValueIsNamedAndCostsItselfOnly) {
  const std::string text = writeSettings(otherSettings());
  for (const Damage& damage : kDamages) {
    SCOPED_TRACE(damage.name);
    const std::string damaged = replaced(text, damage.from, damage.to);
    const ReadSettings read = readSettings(damaged, "my/settings.toml");
    Settings expected = otherSettings();
    damage.costs(expected);
    EXPECT_EQ(read.settings, expected);
    ASSERT_EQ(read.complaints.size(), damage.says.empty() ? 0u : 1u);
    if (damage.says.empty()) continue;
    const std::string& said = read.complaints.front();
    EXPECT_NE(said.find("my/settings.toml, line "), std::string::npos) << said;
    for (const std::string& word : damage.says) EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_TRUE(std::none_of(said.begin(), said.end(), [](char c) { return uint8_t(c) < 0x20; })) << said;
    // Written again, nothing is wrong any more but what this version does not know.
    const ReadSettings again = readSettings(writeSettings(read.settings, read.unknown), "s");
    EXPECT_EQ(again.settings, read.settings);
    EXPECT_FALSE(again.damaged);
    EXPECT_EQ(again.complaints.size(), read.unknown.size());
    EXPECT_EQ(again.unknown, read.unknown);
  }
}

TEST(SettingsText, TheLineIsTheOneThatIsWrong) {
  const std::string damaged = replaced(writeSettings(Settings()), "music = 0.6", "music = \"x\"");
  EXPECT_NE(readSettings(damaged, "s").complaints.at(0).find(lineNumber(damaged, "music =") + ","), std::string::npos);
}

TEST(SettingsText, ASectionThatIsNoneKeepsItsDefaults) {
  const ReadSettings read = readSettings("sound = 3\n[effects]\nshake = 0.5\n", "s");
  ASSERT_EQ(read.complaints.size(), 1u);
  EXPECT_NE(read.complaints[0].find("sound"), std::string::npos);
  EXPECT_NE(read.complaints[0].find("[sound]"), std::string::npos);
  EXPECT_EQ(read.settings.sound, kDefaults.sound);
  EXPECT_EQ(read.settings.effects.shake, 0.5f);
  EXPECT_TRUE(read.damaged);
}

TEST(SettingsText, SeveralThingsWrongAreAllNamed) {
  std::string text = writeSettings(otherSettings());
  text = replaced(text, "music = 0.1", "music = 7");
  text = replaced(text, "shake = 0.5", "shake = true");
  text = replaced(text, "move_up = [\"B\", \"C\"]", "move_up = [\"Bogus\", 3]");
  const ReadSettings read = readSettings(text, "s");
  EXPECT_EQ(read.complaints.size(), 5u) << "both names, and that the default is used for want of any";
  Settings expected = otherSettings();
  expected.sound.music = 0.6f;
  expected.effects.shake = 1;
  useDefault(expected, InputDevice::keyboard, Action::moveUp);
  EXPECT_EQ(read.settings, expected);
}

TEST(SettingsText, EveryFieldRefusesWhatItIsNot) {
  for (const SettingsField& field : settingsFields()) {
    for (const char* value : {"\"x\"", "[]", "{}", "nan", "-1", "2", "07:32:00"}) {
      const std::string key = std::string(field.section) + "." + field.key;
      const ReadSettings read = readSettings(key + " = " + value + "\n", "s");
      EXPECT_EQ(read.settings, kDefaults) << key << value;
      ASSERT_EQ(read.complaints.size(), 1u) << key << value;
      EXPECT_NE(read.complaints[0].find("s, line 1, " + key + ": "), std::string::npos) << read.complaints[0];
    }
  }
}

TEST(SettingsText, AnActionMayHaveNoControlAtAll) {
  const ReadSettings read = readSettings("[keys]\npause = []\nconfirm = []\n", "s");
  EXPECT_TRUE(read.complaints.empty());
  EXPECT_TRUE(read.settings.bindings.codes(InputDevice::keyboard, Action::pause).empty());
  EXPECT_TRUE(withFallBacks(read.settings.bindings).has({InputDevice::keyboard, kKeyEscape}, Action::pause));
}

TEST(SettingsText, WhatIsNotTomlGivesTheDefaultsAndOneSentence) {
  const std::string good = writeSettings(otherSettings());
  const std::pair<const char*, std::string> texts[] = {
      {"cut in a value", good.substr(0, good.find("0.35")) + "\n"},
      {"cut in a list", good.substr(0, good.find("move_up") + 12)},
      {"bytes", std::string("\x7f\x45LF\x01\x00\x00\xff\xfe", 9)},
      {"zeros", std::string(4096, '\0')},
      {"a key twice", "[sound]\nmusic = 0.1\nmusic = 0.2\n"},
      {"a section twice", "[sound]\n[sound]\n"},
      {"bad UTF-8", "[sound]\nmusic = \"\xc3\x28\"\n"},
      {"no quotes", "[keys]\nmove_up = [W]\n"},
      {"deep lists", "a = " + std::string(400, '[') + std::string(400, ']')},
      {"a long line", "a = \"" + std::string(5000, 'x') + "\"\n"},
      {"deep keys",
       [] {
         std::string text;
         for (int i = 0; i < 30000; ++i) text += "a.";
         return text + "a = 1\n";
       }()},
      {"a huge file", std::string(kMaxSettingsText + 1, '\n')},
      {"JSON", "{\"sound\": {\"music\": 1}}"},
  };
  for (const auto& [name, text] : texts) {
    SCOPED_TRACE(name);
    const ReadSettings read = readSettings(text, "my/settings.toml");
    EXPECT_EQ(read.settings, kDefaults);
    EXPECT_TRUE(read.damaged);
    ASSERT_EQ(read.complaints.size(), 1u);
    EXPECT_NE(read.complaints[0].find("my/settings.toml, line "), std::string::npos) << read.complaints[0];
    EXPECT_NE(read.complaints[0].find("defaults are used"), std::string::npos) << read.complaints[0];
    EXPECT_EQ(read.complaints[0].find('\n'), std::string::npos);
  }
}

// No text whatever brings it down, and what it makes of any text can be written and read.
RC_GTEST_PROP(SettingsText, AnyDamageLeavesSettingsThatCanBeWritten, ()) {
  std::string text = writeSettings(otherSettings());
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    const size_t at = *rc::gen::inRange<size_t>(0, text.size());
    const size_t length = *rc::gen::inRange<size_t>(0, 8);
    text.replace(at, length, *rc::gen::arbitrary<std::string>());
    if (text.empty()) text = "x";
  }
  const ReadSettings read = readSettings(text, "s");
  const ReadSettings again = readSettings(writeSettings(read.settings, read.unknown), "s");
  RC_ASSERT(again.settings == read.settings);
  RC_ASSERT(!again.damaged);
}

TEST(SettingsText, ANumberThatIsKeptIsTheNumberThatWasWritten) {
  const ReadSettings read = readSettings("a = 0.7\nb = 1.0\nc = 1e300\nd = -inf\ne = 3\n[sound]\nmusic = 1.7\n", "s");
  const std::vector<std::pair<std::string, std::string>> kept = {
      {"", "a = 0.7"}, {"", "b = 1.0"}, {"", "c = 1e+300"}, {"", "d = -inf"}, {"", "e = 3"}};
  EXPECT_EQ(read.unknown, kept);
  EXPECT_NE(read.complaints.front().find("1.7 is not a number"), std::string::npos) << read.complaints.front();
}

TEST(SettingsText, WhatAnotherVersionUnderstandsIsKept) {
  const std::string text =
      "future = [1, 2]\n\"odd key\" = 'x'\n[smell]\nroses = true\n[smell.more]\nwhen = 07:32:00\n[[lists]]\na = 1\n"
      "[[lists]]\na = 2\n[sound]\nreverb = { room = 0.5 }\nmusic = 0.25\n[keys]\ndance = [\"D\"]\n";
  const ReadSettings read = readSettings(text, "s");
  EXPECT_EQ(read.complaints.size(), 6u);
  EXPECT_FALSE(read.damaged);
  EXPECT_EQ(read.settings.sound.music, 0.25f);
  const std::string written = writeSettings(read.settings, read.unknown);
  for (const char* part :
       {"future = [ 1, 2 ]", "roses = true", "07:32:00", "reverb", "room = 0.5", "dance = [ 'D' ]"}) {
    EXPECT_NE(written.find(part), std::string::npos) << part << "\n" << written;
  }
  EXPECT_EQ(readSettings(written, "s").unknown, read.unknown);
}

}  // namespace
}  // namespace gw::test
