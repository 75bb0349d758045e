// What practice asks for: from presses to the bits of records.
#include "game/session/practice.h"

#include <gtest/gtest.h>

#include <vector>

namespace gw {
namespace {

uint32_t typeOf(uint16_t buttons) {
  return buttons >> kSpawnTypeShift & kSpawnTypeMask;
}
uint32_t countOf(uint16_t buttons) {
  return kPracticeCounts[buttons >> kSpawnCountShift & kSpawnCountMask];
}

TEST(PracticeTest, ARequestStandsInOneRecordWithItsTypeAndCount) {
  Practice practice(7);
  EXPECT_EQ(practice.takeButtons(), 0);
  practice.press({.number = 5, .more = 2});
  EXPECT_EQ(practice.takeButtons(), 0) << "choosing asks for nothing";
  practice.press({.spawn = 1});
  const uint16_t buttons = practice.takeButtons();
  EXPECT_EQ(buttons & (kButtonSpawn | kButtonClear), kButtonSpawn);
  EXPECT_EQ(typeOf(buttons), 4u);
  EXPECT_EQ(countOf(buttons), 50u);
  EXPECT_EQ(buttons & ~kButtonsKnown, 0);
  EXPECT_EQ(practice.takeButtons(), 0);
}

TEST(PracticeTest, EveryPressCountsOnceThoughAHeldButtonDoesNot) {
  Practice practice(7);
  practice.press({.spawn = 3});
  int presses = 0;
  uint16_t before = 0;
  for (int tick = 0; tick < 20; ++tick) {
    const uint16_t now = practice.takeButtons();
    presses += (now & ~before & kButtonSpawn) != 0;
    before = now;
  }
  EXPECT_EQ(presses, 3) << "a button must be up before it counts again";
}

TEST(PracticeTest, WhatWasChosenAtThePressCountsNotWhatIsChosenLater) {
  Practice practice(7);
  practice.press({.spawn = 1});
  practice.press({.number = 3, .spawn = 1});
  EXPECT_EQ(typeOf(practice.takeButtons()), 0u);
  EXPECT_EQ(practice.takeButtons(), 0);
  EXPECT_EQ(typeOf(practice.takeButtons()), 2u);
}

TEST(PracticeTest, ClearsBeforeItBringsNewOnes) {
  Practice practice(7);
  practice.press({.spawn = 1, .clear = 1});
  EXPECT_EQ(practice.takeButtons(), kButtonClear);
  EXPECT_TRUE(practice.takeButtons() & kButtonSpawn) << "another button, so it may follow at once";
  EXPECT_EQ(practice.takeButtons(), 0);
}

TEST(PracticeTest, AHammeredKeyIsSoonForgotten) {
  Practice practice(7);
  for (int i = 0; i < 1000; ++i) practice.press({.spawn = 1});
  size_t asked = 0;
  for (int tick = 0; tick < 100; ++tick) asked += (practice.takeButtons() & kButtonSpawn) != 0;
  EXPECT_EQ(asked, Practice::kMostWaiting);
}

TEST(PracticeTest, ChoicesStayWithinTheTables) {
  Practice practice(3);
  practice.press({.number = 9});
  EXPECT_EQ(practice.type(), 0u) << "there are only three types";
  practice.press({.number = 3});
  practice.press({.nextType = 1});
  EXPECT_EQ(practice.type(), 0u) << "round and round";
  practice.press({.more = 100});
  EXPECT_EQ(kPracticeCounts[practice.number()], 2000u);
  practice.press({.more = -100});
  EXPECT_EQ(kPracticeCounts[practice.number()], 1u);
}

TEST(PracticeTest, ARecordThatAsksForWhatThereIsNotAsksForNothing) {
  Practice practice(7);
  practice.press({.number = 6, .more = -1, .spawn = 1});
  const InputRecord asks{0, 0, 0, practice.takeButtons()};
  ASSERT_TRUE(requestIn(asks, 7));
  EXPECT_EQ(requestIn(asks, 7)->type, 5u);
  EXPECT_EQ(requestIn(asks, 7)->count, 5u);
  EXPECT_FALSE(requestIn(asks, 5)) << "no such type";
  EXPECT_FALSE(requestIn({0, 0, 0, uint16_t(asks.buttons & ~kButtonSpawn)}, 7));
  EXPECT_FALSE(requestIn({0, 0, 0, kButtonSpawn | 15 << kSpawnCountShift}, 7)) << "no such count";
  EXPECT_FALSE(requestIn({0, 0, 0, kButtonSpawn | 7 << kSpawnTypeShift}, 7));
}

TEST(PracticeTest, SlowMotionSwitches) {
  Practice practice(7);
  EXPECT_EQ(practice.speed(), 1);
  practice.press({.slowMotion = 1});
  EXPECT_EQ(practice.speed(), 0.25);
  practice.press({.slowMotion = 2});
  EXPECT_EQ(practice.speed(), 0.25);
  practice.press({.slowMotion = 1});
  EXPECT_FALSE(practice.slow());
}

}  // namespace
}  // namespace gw
