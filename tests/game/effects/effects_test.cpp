// Grid bends, score pops, shake and flash: all follow from reports and the moment they are looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "game/effects/run_effects.h"
#include "game/ui/overlay.h"

namespace gw {
namespace {

TickReport reportAt(uint32_t tick) {
  TickReport report;
  report.tick = tick;
  report.multiplierTenths = 10;
  report.ship_x = report.shipPrevious_x = 50;
  report.ship_y = report.shipPrevious_y = 40;
  return report;
}

TickReport killAt(uint32_t tick, float x, float y, uint32_t points, uint32_t side = 1) {
  TickReport report = reportAt(tick);
  report.pops[side] = {x, y, points};
  return report;
}

TickReport contactAt(uint32_t tick) {
  TickReport report = reportAt(tick);
  report.contactType = 2;
  report.contactCost_us = 12000;
  return report;
}

TickReport soundAt(uint32_t tick, SoundEvent event) {
  TickReport report = reportAt(tick);
  report.sounds[uint32_t(event)][1] = 1;
  if (event == SoundEvent::flush) report.flushRadius_m = 80.0f / 60;
  report.flush_x = 50;
  report.flush_y = 40;
  return report;
}

float strongest(const std::vector<GridBend>& bends) {
  float most = 0;
  for (const GridBend& bend : bends) most = std::max(most, bend.strength_m);
  return most;
}

// ---------------------------------------------------------------- grid

TEST(GridBendsTest, NothingBendsARestingGrid) {
  GridBends bends;
  EXPECT_TRUE(bends.at({0, 1}).empty());
  bends.add(reportAt(1));
  EXPECT_TRUE(bends.at({1, 0.5f}).empty());
}

TEST(GridBendsTest, AKillSendsARippleThatFades) {
  GridBends bends;
  bends.add(killAt(10, 30, 20, 150));
  float radius = -1, strength = 1e9f;
  for (float since = 0; since < 24; since += 0.5f) {
    const auto at = bends.at({10, since});
    ASSERT_EQ(at.size(), 1u) << since;
    EXPECT_EQ(at[0].x, 30);
    EXPECT_EQ(at[0].y, 20);
    EXPECT_GT(at[0].radius_m, radius);
    EXPECT_LT(at[0].strength_m, strength);
    radius = at[0].radius_m;
    strength = at[0].strength_m;
  }
  EXPECT_TRUE(bends.at({10, 60}).empty());
}

TEST(GridBendsTest, LookAsTheyDoAtTheirMomentHoweverManyFramesThereWere) {
  GridBends bends;
  bends.add(killAt(10, 30, 20, 150));
  for (uint32_t tick = 11; tick <= 15; ++tick) bends.add(reportAt(tick));
  const auto once = bends.at({15, 0.25f});
  for (int frame = 0; frame < 7; ++frame) bends.at({15, 0.1f * float(frame)});
  const auto again = bends.at({15, 0.25f});
  ASSERT_EQ(once.size(), 1u);
  EXPECT_EQ(again[0].radius_m, once[0].radius_m);
  // A whole tick later is the same moment as the start of the next tick.
  EXPECT_FLOAT_EQ(bends.at({15, 1})[0].radius_m, bends.at({16, 0})[0].radius_m);
  EXPECT_FLOAT_EQ(bends.at({15, 1})[0].strength_m, bends.at({16, 0})[0].strength_m);
}

TEST(GridBendsTest, ValueCountsAndNotPoints) {
  GridBends early, late;
  early.add(killAt(10, 30, 20, 10));
  TickReport rich = killAt(10, 30, 20, 1000);
  rich.multiplierTenths = 1000;
  late.add(rich);
  EXPECT_FLOAT_EQ(strongest(late.at({10, 1})), strongest(early.at({10, 1})));
}

TEST(GridBendsTest, ContactBendsMoreThanAnyKillAndTheFlushTravelsWithItsRing) {
  GridBends kill, contact, flush;
  kill.add(killAt(10, 30, 20, 100000));
  contact.add(contactAt(10));
  flush.add(soundAt(10, SoundEvent::flush));
  EXPECT_GT(strongest(contact.at({10, 1})), 1.5f * strongest(kill.at({10, 1})));
  for (const float since : {1.0f, 6.0f, 20.0f}) {
    EXPECT_NEAR(flush.at({10, since}).at(0).radius_m, 80 * since / 60, 1e-3f);
  }
}

TEST(GridBendsTest, TheStrongestAreShownWhenThereAreTooMany) {
  GridBends bends;
  bends.add(contactAt(10));
  for (uint32_t tick = 11; tick < 25; ++tick) {
    TickReport report = reportAt(tick);
    for (uint32_t side = 0; side < kPans; ++side) report.pops[side] = {float(tick), float(side), 10};
    bends.add(report);
  }
  const auto at = bends.at({24, 0.5f});
  EXPECT_EQ(at.size(), size_t(kMaxGridBends) - 1);  // one place is the wake's
  EXPECT_EQ(at[0].x, 50);                           // the contact
  EXPECT_TRUE(std::is_sorted(at.begin(), at.end(),
                             [](const GridBend& a, const GridBend& b) { return a.strength_m > b.strength_m; }));
}

TEST(GridBendsTest, TheWakeTrailsAFlyingShipAndSettlesBehindAStandingOne) {
  GridBends bends;
  uint32_t tick = 0;
  TickReport report = reportAt(++tick);
  for (; tick < 60; report.tick = ++tick) {
    report.shipPrevious_x = report.ship_x;
    report.ship_x += 16.0f / 60;
    bends.add(report);
  }
  const auto flying = bends.at({tick - 1, 1});
  ASSERT_EQ(flying.size(), 1u);
  EXPECT_LT(flying[0].x, report.ship_x - 1);
  EXPECT_GT(flying[0].x, report.ship_x - 3);
  EXPECT_GT(flying[0].strength_m, 0.5f);
  EXPECT_LT(flying[0].strength_m, 1.0f);  // gentle
  report.shipPrevious_x = report.ship_x;
  for (int t = 0; t < 60; ++t, report.tick = ++tick) bends.add(report);
  EXPECT_TRUE(bends.at({tick - 1, 1}).empty());
}

// ---------------------------------------------------------------- score pops

TEST(ScorePopsTest, RiseFadeAndGo) {
  ScorePops pops;
  pops.add(killAt(10, 30, 20, 250));
  const auto young = pops.at({10, 1}), old = pops.at({10, 50});
  ASSERT_EQ(young.size(), 1u);
  EXPECT_EQ(young[0].points, 250u);
  EXPECT_EQ(young[0].x, 30);
  EXPECT_EQ(young[0].opacity, 1);
  ASSERT_EQ(old.size(), 1u);
  EXPECT_GT(old[0].y, young[0].y);
  EXPECT_LT(old[0].opacity, 0.5f);
  EXPECT_TRUE(pops.at({10, float(ScorePops::kLife_ticks)}).empty());
}

TEST(ScorePopsTest, NearOnesShareANumberFarOnesDoNot) {
  ScorePops pops;
  pops.add(killAt(10, 30, 20, 100));
  pops.add(killAt(14, 32, 20, 50));  // near and soon
  pops.add(killAt(15, 40, 20, 30));  // too far
  auto shown = pops.at({15, 0.5f});
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[0].points, 150u);
  EXPECT_EQ(shown[0].x, 30);  // it stays where it was
  EXPECT_EQ(shown[1].points, 30u);
  pops.add(killAt(10 + ScorePops::kMerges_ticks, 30, 20, 7));  // too late
  EXPECT_EQ(pops.at({26, 0.5f}).size(), 3u);
}

TEST(ScorePopsTest, AreLargerTheMoreTheyAreWorth) {
  float last = 0;
  for (const uint32_t points : {10u, 150u, 2000u, 20000u}) {
    ScorePops pops;
    pops.add(killAt(10, 30, 20, points));
    const float size = pops.at({10, 20}).at(0).size;
    EXPECT_GT(size, last);
    last = size;
  }
  ScorePops most;
  most.add(killAt(10, 30, 20, 0xFFFFFFFFu));
  EXPECT_EQ(most.at({10, 20}).at(0).size, last);  // nothing fills the screen
}

TEST(ScorePopsTest, TheValuableStayWhenThereAreTooMany) {
  ScorePops pops;
  pops.add(killAt(1, 0, 0, 5000));
  for (uint32_t tick = 2; tick < 20; ++tick) {
    TickReport report = reportAt(tick);
    for (uint32_t side = 0; side < kPans; ++side) report.pops[side] = {float(tick) * 10, float(side) * 10, 10 + tick};
    pops.add(report);
  }
  const auto shown = pops.at({19, 1});
  EXPECT_EQ(shown.size(), ScorePops::kMost);
  EXPECT_EQ(shown[0].points, 5000u);
  EXPECT_EQ(shown.back().points, 29u);  // the newest is there
  EXPECT_GT(shown[1].points, 12u);      // the least of the old ones went
}

// ---------------------------------------------------------------- shake

float reach(const Shake& shake, uint32_t tick, float scale = 1) {
  float most = 0;
  for (float since = 0; since < 12; since += 0.25f) {
    const Shake::Offset offset = shake.at({tick, since}, scale);
    most = std::max(most, std::hypot(offset.x, offset.y));
  }
  return most;
}

TEST(ShakeTest, OffIsExactlyNothing) {
  Shake shake;
  shake.add(contactAt(10));
  for (float since = 0; since < 40; since += 0.25f) {
    const Shake::Offset offset = shake.at({10, since}, 0);
    EXPECT_EQ(offset.x, 0.0f);
    EXPECT_EQ(offset.y, 0.0f);
  }
  EXPECT_GT(reach(shake, 10), 0.2f);
}

TEST(ShakeTest, WearsOffAndStaysWithinItsReach) {
  Shake shake;
  EXPECT_EQ(reach(shake, 0), 0);
  shake.add(contactAt(10));
  shake.add(soundAt(11, SoundEvent::over));
  shake.add(soundAt(12, SoundEvent::flush));
  EXPECT_LE(reach(shake, 12), Shake::kMost_m * 1.4143f);
  EXPECT_LT(reach(shake, 12 + 20), 0.5f * reach(shake, 12));
  EXPECT_EQ(reach(shake, 12 + 41), 0);
}

TEST(ShakeTest, ScalesEverySource) {
  for (const TickReport& report :
       {contactAt(10), soundAt(10, SoundEvent::flush), soundAt(10, SoundEvent::over), killAt(10, 30, 20, 150)}) {
    Shake shake;
    shake.add(report);
    EXPECT_GT(reach(shake, 10), 0);
    EXPECT_NEAR(reach(shake, 10, 0.5f), reach(shake, 10) / 2, 1e-5f);
    EXPECT_EQ(reach(shake, 10, 0), 0);
  }
}

TEST(ShakeTest, ContactIsFeltMostAndSmallKillsNotAtAll) {
  Shake contact, flush, heavy, light;
  contact.add(contactAt(10));
  flush.add(soundAt(10, SoundEvent::flush));
  heavy.add(killAt(10, 30, 20, 150));
  TickReport rich = killAt(10, 30, 20, 2500);  // a triangle at x250
  rich.multiplierTenths = 2500;
  light.add(rich);
  EXPECT_GT(reach(contact, 10), reach(flush, 10));
  EXPECT_GT(reach(flush, 10), reach(heavy, 10));
  EXPECT_GT(reach(heavy, 10), 0);
  EXPECT_EQ(reach(light, 10), 0);
}

TEST(ShakeTest, ManyHeavyKillsDoNotShakeAsAContactDoes) {
  Shake heavy, contact;
  for (uint32_t tick = 10; tick < 40; ++tick) heavy.add(killAt(tick, 30, 20, 150));
  contact.add(contactAt(39));
  EXPECT_LT(reach(heavy, 39), 0.6f * reach(contact, 39));
}

TEST(ShakeTest, HoldsStillWhileTicksAreWithheld) {
  Shake shake;
  shake.add(contactAt(10));
  const Shake::Offset first = shake.at({10, 0.4f}, 1), later = shake.at({10, 0.4f}, 1);
  EXPECT_EQ(first.x, later.x);
  EXPECT_EQ(first.y, later.y);
  const Shake::Offset end = shake.at({10, 1}, 1), start = shake.at({11, 0}, 1);
  EXPECT_NEAR(end.x, start.x, 1e-4f);  // no jump from tick to tick
  EXPECT_NEAR(end.y, start.y, 1e-4f);
}

// ---------------------------------------------------------------- flash

TEST(FlashTest, ContactIsARedEdgeAndTheFlushIsBlueWhite) {
  Flash flash;
  EXPECT_EQ(flash.at({0, 1}, 1).colour.alpha, 0);
  flash.add(contactAt(10));
  const FlashLight contact = flash.at({10, 1}, 1);
  EXPECT_TRUE(contact.edge);
  EXPECT_GT(contact.colour.red, 2 * contact.colour.blue);
  EXPECT_LT(flash.at({10, 15}, 1).colour.alpha, contact.colour.alpha / 2);
  EXPECT_EQ(flash.at({10, 30}, 1).colour.alpha, 0);
  flash.add(soundAt(60, SoundEvent::flush));
  const FlashLight flush = flash.at({60, 1}, 1);
  EXPECT_FALSE(flush.edge);
  EXPECT_GT(flush.colour.blue, flush.colour.red);
}

TEST(FlashTest, IsScaledAndOffIsNone) {
  Flash flash;
  flash.add(contactAt(10));
  EXPECT_FLOAT_EQ(flash.at({10, 1}, 0.5f).colour.alpha, flash.at({10, 1}, 1).colour.alpha / 2);
  EXPECT_EQ(flash.at({10, 1}, 0).colour.alpha, 0);
}

TEST(FlashTest, NeverBeginsMoreThanThreeTimesInAnySecond) {
  Flash flash;
  std::vector<uint32_t> begun;
  float before = 0;
  for (uint32_t tick = 1; tick < 600; ++tick) {  // something happens in every tick
    flash.add(tick % 2 ? contactAt(tick) : soundAt(tick, SoundEvent::flush));
    const float now = flash.at({tick, 0}, 1).colour.alpha;
    if (now > before) begun.push_back(tick);
    before = now;
  }
  ASSERT_GT(begun.size(), 10u);
  for (size_t i = 3; i < begun.size(); ++i) EXPECT_GT(begun[i] - begun[i - 3], kTicksPerSecond);
}

// ---------------------------------------------------------------- together

TEST(RunEffectsTest, ARepeatedReportChangesNothing) {
  RunEffects effects;
  effects.add(killAt(10, 30, 20, 150));
  effects.add(killAt(10, 30, 20, 150));  // after the end ticks repeat the last report
  EXPECT_EQ(effects.scorePops().at({10, 1}).at(0).points, 150u);
  EXPECT_EQ(effects.gridBends().at({10, 1}).size(), 1u);
}

class RememberingCanvas final : public Canvas {
 public:
  float width() const override { return 1280; }
  void rectangle(float left, float top, float width, float height, Rgba) override {
    middleLit |= left < 600 && left + width > 680 && top < 340 && top + height > 380;
    ++shapes;
  }
  void gradient(float left, float top, float width, float height, Rgba, Rgba) override {
    rectangle(left, top, width, height, {});
  }
  void outline(float, float, float, float, float, Rgba) override {}
  void line(float, float, float, float, float, Rgba) override {}
  void triangle(float, float, float, float, float, float, Rgba) override {}
  void text(std::string_view text, float x, float baseline, const TextStyle& style) override {
    words = text;
    word_x = x;
    word_y = baseline - style.size_px / 2;
  }
  float textWidth(std::string_view, float) const override { return 10; }
  void nextLayer() override {}

  int shapes = 0;
  bool middleLit = false;
  std::string words;
  float word_x = 0, word_y = 0;
};

TEST(EffectsOverlayTest, TheEdgeLeavesTheMiddleAlone) {
  RememberingCanvas none, edge, whole;
  drawFlash(none, {});
  EXPECT_EQ(none.shapes, 0);
  drawFlash(edge, {{1, 0, 0, 0.5f}, true});
  EXPECT_GT(edge.shapes, 4);
  EXPECT_FALSE(edge.middleLit);
  drawFlash(whole, {{1, 1, 1, 0.2f}, false});
  EXPECT_TRUE(whole.middleLit);
}

TEST(EffectsOverlayTest, PointsStandWhereTheyWereScored) {
  RememberingCanvas canvas;
  const std::vector<ScorePops::Shown> pops{{60, 50, 1234, 14, 1}};
  drawScorePops(canvas, pops, {50, 40, 32, 18}, 1);
  EXPECT_EQ(canvas.words, "1,234");
  EXPECT_NEAR(canvas.word_x, 640 + 10 * 20, 0.1f);
  EXPECT_NEAR(canvas.word_y, 360 - 10 * 20, 0.1f);
}

}  // namespace
}  // namespace gw
