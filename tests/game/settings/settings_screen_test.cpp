// What the settings screen and the hints say.
#include "game/ui/settings_screen.h"

#include <gtest/gtest.h>

#include "game/settings/settings_fields.h"
#include "game/ui/key_hints.h"
#include "tests/game/settings/settings_samples.h"
#include "tests/game/ui/remembering_canvas.h"

namespace gw::test {
namespace {

TEST(SettingsScreen, ShowsEveryValueAndEveryActionOnTheCanvas) {
  for (const Settings& settings : {Settings(), otherSettings()}) {
    RememberingCanvas canvas;
    drawSettings(canvas, SettingsMenu(settings), {});
    for (const SettingsField& field : settingsFields()) EXPECT_TRUE(canvas.says(field.label)) << field.label;
    for (uint32_t i = 0; i < kActions; ++i) {
      std::string label(actionName(Action(i)));
      std::replace(label.begin(), label.end(), '_', ' ');
      EXPECT_TRUE(canvas.says(label)) << label;
    }
    EXPECT_EQ(canvas.outside(), "");
  }
  RememberingCanvas canvas;
  drawSettings(canvas, SettingsMenu(Settings()), {});
  for (const char* text : {"80%", "60%", "OFF", "ON", "W", "LMB", "START", "ESC: back"}) {
    EXPECT_TRUE(canvas.says(text)) << text;
  }
}

TEST(SettingsScreen, CutsWhatIsTooLong) {
  Settings settings;
  settings.bindings.codes(InputDevice::keyboard, Action::flush) = {224, 225, 226, 227, 228, 229, 230, 231};
  RememberingCanvas canvas;
  drawSettings(canvas, SettingsMenu(settings), {});
  EXPECT_TRUE(canvas.says(".."));
  EXPECT_FALSE(canvas.says("R GUI"));
}

TEST(SettingsScreen, SaysThatItWaitsAndForHowLong) {
  SettingsMenu menu{Settings()};
  menu.press({.otherColumn = true}, 10);
  menu.press({.confirm = true}, 10);
  RememberingCanvas keys, pad;
  drawSettings(keys, menu, {11.5, false});
  EXPECT_TRUE(keys.says("press a key or button ... 4"));
  EXPECT_TRUE(keys.says("ESC: leave it"));
  menu.hear({InputDevice::keyboard, 22});
  drawSettings(pad, menu, {12, true});
  EXPECT_TRUE(pad.says("S was move down, which is now W"));
  EXPECT_TRUE(pad.says("B: back"));
}

TEST(KeyHints, NameTheKeysAsTheyAreBound) {
  const KeyHints usual = keyHints(Bindings(), false), written;
  EXPECT_EQ(usual.move, written.move);
  EXPECT_EQ(usual.aim, written.aim);
  EXPECT_EQ(usual.confirmToo, written.confirmToo);
  for (const auto hint :
       {&KeyHints::flush,    &KeyHints::pause,      &KeyHints::confirm,    &KeyHints::retry,  &KeyHints::quit,
        &KeyHints::settings, &KeyHints::fullscreen, &KeyHints::mute,       &KeyHints::spawn,  &KeyHints::clear,
        &KeyHints::more,     &KeyHints::fewer,      &KeyHints::slowMotion, &KeyHints::stepOn, &KeyHints::stepBack,
        &KeyHints::faster,   &KeyHints::slower,     &KeyHints::camera,     &KeyHints::help,   &KeyHints::ship,
        &KeyHints::pan}) {
    EXPECT_EQ(usual.*hint, written.*hint) << "the defaults are the defaults";
  }
  Bindings bindings;
  bindings.codes(InputDevice::keyboard, Action::moveUp) = {96};
  bindings.codes(InputDevice::keyboard, Action::pause) = {};
  bindings.codes(InputDevice::keyboard, Action::retry) = {};
  bindings.codes(InputDevice::mouse, Action::fire) = {};
  const KeyHints other = keyHints(bindings, false);
  EXPECT_EQ(other.move, "KP 8, A, S, D");
  EXPECT_EQ(other.aim, "ARROWS");
  EXPECT_EQ(other.pause, "ESC") << "the fall-back";
  EXPECT_EQ(other.retry, "-");
  const KeyHints pad = keyHints(bindings, true);
  EXPECT_EQ(pad.move, "LEFT STICK");
  EXPECT_EQ(pad.confirm, "A");
  EXPECT_EQ(pad.pause, "START");
  EXPECT_EQ(pad.settings, "Y");
}

}  // namespace
}  // namespace gw::test
