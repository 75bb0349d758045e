// Values changed in a text as the player wrote it: everything else stays to the byte.
#include "game/settings/settings_edit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/game/settings/settings_samples.h"

namespace gw::test {
namespace {

struct Edit {
  const char* name;
  std::string before, after;
};

// `change` of what each text says.
void check(const std::vector<Edit>& edits, const std::function<void(Settings&)>& change) {
  for (const Edit& edit : edits) {
    SCOPED_TRACE(edit.name);
    const ReadSettings read = readSettings(edit.before, "s");
    Settings now = read.settings;
    change(now);
    EXPECT_EQ(editSettings(edit.before, read, now).value_or("none"), edit.after);
  }
}

TEST(SettingsEdit, ANumberIsPutInItsPlace) {
  check({{"a comment behind it", "[sound]\nmusic = 0.70 # loud\n", "[sound]\nmusic = 0.25 # loud\n"},
         {"spaces", "[ sound ]\n\tmusic=0.7\n", "[ sound ]\n\tmusic=0.25\n"},
         {"quotes", "[\"sound\"]\n'music' = 7e-1\n", "[\"sound\"]\n'music' = 0.25\n"},
         {"a dotted key", "sound.music = 0.7\n", "sound.music = 0.25\n"},
         {"an inline table", "sound = { effects = 1, music = 0.7 }\n", "sound = { effects = 1, music = 0.25 }\n"},
         {"no end of the line", "[sound]\nmusic = 0.7", "[sound]\nmusic = 0.25"},
         {"letters of several bytes", "# \xc3\xa4\xe2\x82\xac\nsound = { music = 0.7 } # \xc3\xb6\n",
          "# \xc3\xa4\xe2\x82\xac\nsound = { music = 0.25 } # \xc3\xb6\n"},
         {"ends of lines from elsewhere", "[sound]\r\nmusic = 0.7\r\n", "[sound]\r\nmusic = 0.25\r\n"},
         {"another version's keys", "[sound]\nreverb = 0.7\nmusic = 1\n[smell]\nroses = [ 1,\n 2 ]\n",
          "[sound]\nreverb = 0.7\nmusic = 0.25\n[smell]\nroses = [ 1,\n 2 ]\n"}},
        [](Settings& settings) { settings.sound.music = 0.25f; });
}

TEST(SettingsEdit, WhatIsLackingGoesBehindTheOthersOfItsSection) {
  check(
      {{"nothing there", "", "\n[sound]\nmusic = 0.25\n"},
       {"another section", "[pad]\n", "[pad]\n\n[sound]\nmusic = 0.25\n"},
       {"without its last end of line", "[pad]", "[pad]\n\n[sound]\nmusic = 0.25\n"},
       {"an empty section", "[sound]\n[pad]\n", "[sound]\nmusic = 0.25\n[pad]\n"},
       {"behind others", "[sound]\nmuted = true\n\n# pads\n[pad]\n",
        "[sound]\nmuted = true\nmusic = 0.25\n\n# pads\n[pad]\n"},
       {"at the end", "[sound]\nmuted = true", "[sound]\nmuted = true\nmusic = 0.25"},
       {"dotted keys", "sound.muted = true\n[pad]\n", "sound.muted = true\nsound.music = 0.25\n[pad]\n"},
       {"an inline table", "sound = { muted = true }\n", "sound = { muted = true, music = 0.25 }\n"},
       {"an empty one", "sound = {}\n", "sound = { music = 0.25 }\n"},
       {"a table below it", "[sound.more]\na = 1\n", "[sound.more]\na = 1\n\n[sound]\nmusic = 0.25\n"},
       {"ends of lines from elsewhere", "[sound]\r\nmuted = true\r\n", "[sound]\r\nmuted = true\r\nmusic = 0.25\r\n"}},
      [](Settings& settings) { settings.sound.music = 0.25f; });
}

TEST(SettingsEdit, SeveralChangesAreMadeAtOnce) {
  check({{"three sections", "# all\n[keys]\nfire = [\n  \"J\", # mine\n]\n[sound]\neffects = 1",
          "# all\n[keys]\nfire = [\"K\"]\nflush = []\n[sound]\neffects = 0.5\nmuted = true\n\n[mouse]\nfire = "
          "[\"x1\"]\n"}},
        [](Settings& settings) {
          settings.sound.effects = 0.5f;
          settings.sound.muted = true;
          settings.bindings.codes(InputDevice::keyboard, Action::fire) = {14};
          settings.bindings.codes(InputDevice::keyboard, Action::flush) = {};
          settings.bindings.codes(InputDevice::mouse, Action::fire) = {4};
        });
}

TEST(SettingsEdit, WhatIsWrongGetsWhatIsUsedInItsPlace) {
  check({{"numbers", "[sound] # mine\nmusic = 9\neffects = nan\n[keys]\nfire = 3\n",
          "[sound] # mine\nmusic = 0.6\neffects = 0.5\n[keys]\nfire = [\"J\"]\n"}},
        [](Settings& settings) {
          settings.sound.effects = 0.5f;
          settings.bindings.codes(InputDevice::keyboard, Action::fire) = {13};
        });
}

TEST(SettingsEdit, WhatCannotBeEditedIsNot) {
  for (const char* text : {"[sound\n", "sound = 3\n", "[[sound]]\nmusic = 1\n"}) {
    const ReadSettings read = readSettings(text, "s");
    EXPECT_EQ(editSettings(text, read, otherSettings()), std::nullopt) << text;
  }
}

TEST(SettingsEdit, NothingChangedIsTheSameText) {
  const std::string text = "# a\n[sound]\nmusic = 7e-1\n[keys]\nfire = [ 'J' ]\n";
  const ReadSettings read = readSettings(text, "s");
  EXPECT_EQ(editSettings(text, read, read.settings), text);
}

// Whatever stands between them: what is written by the game can always be changed in its place.
RC_GTEST_PROP(SettingsEdit, AWrittenFileCanBeEditedWithCommentsAnywhere, ()) {
  std::string text = writeSettings(otherSettings(), {{"", "future = 0.7"}, {"sound", "reverb = 1"}});
  for (int i = *rc::gen::inRange(0, 9); i > 0; --i) {
    const size_t at = text.find('\n', *rc::gen::inRange<size_t>(0, text.size() - 1));
    text.insert(at, *rc::gen::element<std::string>(" # one", "\n# two", "\n", "\n\t", " # \xe2\x82\xac"));
  }
  const ReadSettings read = readSettings(text, "s");
  RC_ASSERT(!read.damaged);
  const auto edited = editSettings(text, read, Settings());
  RC_ASSERT(edited.has_value());
  RC_ASSERT(std::count(edited->begin(), edited->end(), '#') == std::count(text.begin(), text.end(), '#'));
  RC_ASSERT(readSettings(*edited, "s").settings == Settings());
}

}  // namespace
}  // namespace gw::test
