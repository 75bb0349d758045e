// The settings screen: presses in, settings out; and what rebinding does to others.
#include "game/settings/settings_menu.h"

#include <gtest/gtest.h>

#include "game/settings/rebind.h"
#include "game/settings/settings_fields.h"

namespace gw {
namespace {

constexpr uint16_t kKeyE = 8, kKeyS = 22, kKeyW = 26, kKeySpace = 44, kKeyR = 21;
constexpr Control key(uint16_t code) {
  return {InputDevice::keyboard, code};
}

TEST(Rebind, PracticeSharesKeysWithMenusButNotWithPlay) {
  Bindings bindings;
  EXPECT_TRUE(bindings.has({InputDevice::pad, kPadY}, Action::spawn) &&
              bindings.has({InputDevice::pad, kPadY}, Action::settings));
  EXPECT_EQ(rebind(bindings, Action::spawn, key(kKeyR), false), "") << "R starts again in menus only";
  EXPECT_TRUE(bindings.has(key(kKeyR), Action::retry));
  EXPECT_NE(rebind(bindings, Action::clear, key(kKeySpace), false), "") << "space flushes, in practice too";
  EXPECT_FALSE(bindings.has(key(kKeySpace), Action::flush));
}

TEST(Rebind, ReplacesOrAdds) {
  Bindings bindings;
  EXPECT_EQ(rebind(bindings, Action::moveUp, key(kKeyE), false), "");
  EXPECT_EQ(bindings.codes(InputDevice::keyboard, Action::moveUp), std::vector<uint16_t>{kKeyE});
  EXPECT_EQ(rebind(bindings, Action::moveUp, key(kKeyW), true), "");
  EXPECT_EQ(bindings.codes(InputDevice::keyboard, Action::moveUp), (std::vector<uint16_t>{kKeyE, kKeyW}));
  EXPECT_EQ(rebind(bindings, Action::moveUp, key(kKeyW), true), "") << "it is there already";
  EXPECT_EQ(bindings.codes(InputDevice::keyboard, Action::moveUp), (std::vector<uint16_t>{kKeyE, kKeyW}));
  EXPECT_EQ(bindings.codes(InputDevice::pad, Action::moveUp), Bindings().codes(InputDevice::pad, Action::moveUp))
      << "other devices keep theirs";
}

TEST(Rebind, TwoActionsOfPlaySwap) {
  Bindings bindings;
  const std::string note = rebind(bindings, Action::moveUp, key(kKeyS), false);
  EXPECT_NE(note.find("move down"), std::string::npos) << note;
  EXPECT_TRUE(bindings.has(key(kKeyS), Action::moveUp));
  EXPECT_FALSE(bindings.has(key(kKeyS), Action::moveDown));
  EXPECT_TRUE(bindings.has(key(kKeyW), Action::moveDown));
}

TEST(Rebind, PlayAndMenusMayShareAKey) {
  Bindings bindings;
  EXPECT_EQ(rebind(bindings, Action::fire, key(kKeyR), false), "") << "R starts again in menus only";
  EXPECT_TRUE(bindings.has(key(kKeyR), Action::retry));
  EXPECT_EQ(rebind(bindings, Action::moveUp, key(kKeySpace), false).find("confirm"), std::string::npos);
  EXPECT_TRUE(bindings.has(key(kKeySpace), Action::confirm));
  EXPECT_FALSE(bindings.has(key(kKeySpace), Action::flush));
}

TEST(Rebind, NoMoreThanAFileMayHold) {
  Bindings bindings;
  for (uint16_t code = 100; code < 120; ++code) rebind(bindings, Action::moveUp, key(code), true);
  EXPECT_EQ(bindings.codes(InputDevice::keyboard, Action::moveUp).size(), kMaxControls);
  EXPECT_FALSE(rebind(bindings, Action::moveUp, key(121), true).empty());
}

TEST(Rebind, ThePauseStaysReachable) {
  Bindings bindings;
  for (auto& device : bindings.of) device[uint32_t(Action::pause)].clear();
  const Bindings reachable = withFallBacks(bindings);
  EXPECT_TRUE(reachable.has(key(kKeyEscape), Action::pause));
  EXPECT_TRUE(reachable.has({InputDevice::pad, kPadStart}, Action::pause));
  bindings.codes(InputDevice::keyboard, Action::pause) = {kKeyE};
  EXPECT_FALSE(withFallBacks(bindings).has(key(kKeyEscape), Action::pause)) << "who has a pause needs no other";
}

class SettingsMenuTest : public ::testing::Test {
 protected:
  void go(uint32_t row) {
    MenuPresses presses;
    presses.down = int(row) - int(menu.row());
    menu.press(presses, 0);
    ASSERT_EQ(menu.row(), row);
  }
  void press(int MenuPresses::*direction, int times = 1) {
    MenuPresses presses;
    presses.*direction = times;
    menu.press(presses, 0);
  }
  void press(bool MenuPresses::*button, double now_s = 0) {
    MenuPresses presses;
    presses.*button = true;
    menu.press(presses, now_s);
  }
  static uint32_t rowOf(Action action) { return SettingsMenu::firstAction() + uint32_t(action); }

  SettingsMenu menu{Settings{}};
};

TEST_F(SettingsMenuTest, EveryNumberGoesFromEndToEndAndNoFurther) {
  for (uint32_t i = 0; i < settingsFields().size(); ++i) {
    const SettingsField& field = settingsFields()[i];
    if (!field.number) continue;
    go(i);
    Settings settings;
    press(&MenuPresses::right, 100);
    settings = menu.settings();
    EXPECT_EQ(*field.number(settings), field.most) << field.label;
    for (int step = 0; step < 100; ++step) press(&MenuPresses::left);
    settings = menu.settings();
    EXPECT_EQ(*field.number(settings), 0) << field.label;
    press(&MenuPresses::right);
    settings = menu.settings();
    EXPECT_FLOAT_EQ(*field.number(settings), 0.05f) << field.label;
  }
}

TEST_F(SettingsMenuTest, EverySwitchSwitches) {
  for (uint32_t i = 0; i < settingsFields().size(); ++i) {
    const SettingsField& field = settingsFields()[i];
    if (!field.flag) continue;
    go(i);
    Settings before = menu.settings();
    press(&MenuPresses::confirm);
    Settings after = menu.settings();
    EXPECT_NE(*field.flag(after), *field.flag(before)) << field.label;
    press(&MenuPresses::left);
    EXPECT_EQ(menu.settings(), before) << field.label;
  }
}

TEST_F(SettingsMenuTest, RowsGoRound) {
  press(&MenuPresses::up);
  EXPECT_EQ(menu.row(), SettingsMenu::rows() - 1);
  press(&MenuPresses::down);
  EXPECT_EQ(menu.row(), 0u);
  press(&MenuPresses::otherColumn);
  EXPECT_EQ(menu.row(), SettingsMenu::firstAction());
  press(&MenuPresses::otherColumn);
  EXPECT_EQ(menu.row(), 0u);
}

TEST_F(SettingsMenuTest, AnActionTakesTheNextKey) {
  go(rowOf(Action::moveUp));
  menu.hear(key(kKeyE));
  EXPECT_EQ(menu.settings(), Settings()) << "no key was asked for yet";
  press(&MenuPresses::confirm);
  ASSERT_TRUE(menu.waiting());
  press(&MenuPresses::down);
  EXPECT_EQ(menu.row(), rowOf(Action::moveUp)) << "nothing else moves meanwhile";
  menu.hear(key(kKeyE));
  EXPECT_FALSE(menu.waiting());
  EXPECT_EQ(menu.settings().bindings.codes(InputDevice::keyboard, Action::moveUp), std::vector<uint16_t>{kKeyE});
  press(&MenuPresses::right);
  menu.hear({InputDevice::pad, kPadLeftStick});
  EXPECT_EQ(menu.settings().bindings.codes(InputDevice::pad, Action::moveUp),
            (std::vector<uint16_t>{kPadUp, kPadLeftStick}));
  press(&MenuPresses::left);
  EXPECT_EQ(menu.settings(), Settings()) << "left gives the defaults back";
}

TEST_F(SettingsMenuTest, WaitingEndsWithEscapeOrTime) {
  go(rowOf(Action::fire));
  press(&MenuPresses::confirm);
  MenuPresses escape;
  escape.escape = escape.back = true;
  menu.press(escape, 1);
  EXPECT_FALSE(menu.waiting());
  EXPECT_FALSE(menu.done()) << "Escape ends one thing at a time";
  press(&MenuPresses::confirm);
  menu.press({}, 4.9);
  EXPECT_TRUE(menu.waiting());
  menu.press({}, 5.1);
  EXPECT_FALSE(menu.waiting());
  EXPECT_EQ(menu.settings(), Settings());
}

TEST_F(SettingsMenuTest, ResetAndDone) {
  press(&MenuPresses::right);
  ASSERT_NE(menu.settings(), Settings());
  go(SettingsMenu::resetRow());
  press(&MenuPresses::right);
  EXPECT_NE(menu.settings(), Settings()) << "only on purpose";
  press(&MenuPresses::confirm);
  EXPECT_EQ(menu.settings(), Settings());
  go(SettingsMenu::doneRow());
  EXPECT_FALSE(menu.done());
  press(&MenuPresses::confirm);
  EXPECT_TRUE(menu.done());
}

TEST_F(SettingsMenuTest, BackLeaves) {
  press(&MenuPresses::back);
  EXPECT_TRUE(menu.done());
}

}  // namespace
}  // namespace gw
