// What each mode shows: on the title, while playing, and at its end.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "game/ui/game_over.h"
#include "game/ui/hud.h"
#include "game/ui/practice_panel.h"
#include "game/ui/session_best.h"
#include "game/ui/theme.h"
#include "game/ui/title.h"
#include "tests/game/ui/remembering_canvas.h"

namespace gw {
namespace {

constexpr Mode kAll[] = {Mode::arcade, Mode::deadline, Mode::swarm, Mode::practice};

Rules someRules() {
  Rules rules{};
  rules.budget.start_us = 16667;
  rules.budget.limit_us = 83333;
  rules.deadline.clock_ticks = 180 * 60;
  rules.deadline.contactTicks_per_ms = 18;
  rules.enemyTypeCount = 7;
  const char* names[] = {"triangle", "quad", "hexagon", "vertex", "texel", "fragment", "compute"};
  for (uint32_t i = 0; i < 7; ++i) {
    std::strcpy(rules.enemies[i].name, names[i]);
    rules.enemies[i].shape = Shape(i);
    rules.enemies[i].speed_mps = 9;
    rules.enemies[i].energy = 30;
  }
  return rules;
}

TickReport reportAt(uint32_t tick) {
  TickReport report;
  report.tick = tick;
  report.frameTime_us = 16667;
  return report;
}

RunMonitor after(const TickReport& report) {
  RunMonitor run;
  run.add(report);
  return run;
}

const RememberingCanvas::Text* find(const RememberingCanvas& canvas, const std::string& text) {
  for (const auto& t : canvas.texts) {
    if (t.text == text) return &t;
  }
  return nullptr;
}

bool isColour(const RememberingCanvas::Text* text, Rgba colour) {
  const Rgba& c = text->style.colour;
  return c.red == colour.red && c.green == colour.green && c.blue == colour.blue;
}

TEST(ModeChoiceTest, GoesRoundBothWays) {
  EXPECT_EQ(modeBeside(Mode::arcade, 1), Mode::deadline);
  EXPECT_EQ(modeBeside(Mode::arcade, -1), Mode::practice);
  EXPECT_EQ(modeBeside(Mode::practice, 1), Mode::arcade);
  for (const Mode mode : kAll) {
    EXPECT_EQ(modeBeside(mode, 0), mode);
    EXPECT_EQ(modeBeside(mode, 4), mode);
    EXPECT_EQ(modeBeside(mode, -5), modeBeside(mode, -1));
  }
}

TEST(ModeChoiceTest, TheTitleMarksOneOfFourAndSaysWhatItIs) {
  for (const Mode chosen : kAll) {
    RememberingCanvas canvas;
    drawTitle(canvas, {2, "cpu, 2 threads", 8192, chosen, "12,345"});
    for (const char* name : {"ARCADE", "DEADLINE", "SWARM", "PRACTICE"}) {
      const auto* text = find(canvas, name);
      ASSERT_NE(text, nullptr) << name;
      std::string lower = name;
      for (char& c : lower) c = char(c | 32);
      EXPECT_EQ(isColour(text, theme::kGold), lower == modeName(chosen)) << name;
    }
    EXPECT_TRUE(canvas.says(std::string(modeLine(chosen))));
    EXPECT_TRUE(canvas.says("best 12,345"));
    EXPECT_EQ(canvas.outside(), "");
  }
}

TEST(ModeHudTest, DeadlineShowsTheClockAndItsLastSecondsInRed) {
  TickReport report = reportAt(600);
  report.clock_ticks = 95 * 60 + 30;
  HudFrame frame;
  frame.mode = Mode::deadline;
  RememberingCanvas early, late;
  drawHud(early, after(report), someRules(), frame);
  ASSERT_NE(find(early, "1:35.5"), nullptr);
  EXPECT_GE(find(early, "1:35.5")->style.size_px, 30) << "large";
  EXPECT_FALSE(isColour(find(early, "1:35.5"), theme::kDanger));
  EXPECT_FALSE(early.says("BUDGET")) << "contacts cost the clock, not frame time";
  report.clock_ticks = 10 * 60;
  drawHud(late, after(report), someRules(), frame);
  ASSERT_NE(find(late, "0:10.0"), nullptr);
  EXPECT_TRUE(isColour(find(late, "0:10.0"), theme::kDanger));
  EXPECT_EQ(early.outside(), "");
}

TEST(ModeHudTest, TheOverclockIsShownOnceItRises) {
  TickReport report = reportAt(600);
  for (const Mode mode : {Mode::arcade, Mode::deadline}) {
    HudFrame frame;
    frame.mode = mode;
    RememberingCanvas before, later;
    report.pace = 1.0f;
    drawHud(before, after(report), someRules(), frame);
    EXPECT_FALSE(before.says("OVERCLOCK"));
    report.pace = 1.035f;
    drawHud(later, after(report), someRules(), frame);
    EXPECT_TRUE(later.says("OVERCLOCK"));
    EXPECT_NE(find(later, "x1.03"), nullptr);
    EXPECT_EQ(later.outside(), "");
  }
}

TEST(ModeHudTest, AContactInDeadlineSaysSeconds) {
  TickReport hit = reportAt(100);
  hit.contactType = 2;
  hit.contactCost_us = 12000;
  hit.clock_ticks = 9000;
  HudFrame frame;
  frame.mode = Mode::deadline;
  RememberingCanvas canvas;
  drawHud(canvas, after(hit), someRules(), frame);
  EXPECT_TRUE(canvas.says("HEXAGON  -3.6 s"));
  EXPECT_FALSE(canvas.says(" ms"));
  EXPECT_FALSE(canvas.says("FPS"));
}

TEST(ModeHudTest, SwarmShowsWhatIsLeftAndTheTime) {
  TickReport report = reportAt(60 * 75 + 30);
  report.enemies = 1204;
  HudFrame frame;
  frame.mode = Mode::swarm;
  frame.enemies = 20000;
  frame.best = "3:12.4";
  RememberingCanvas canvas;
  drawHud(canvas, after(report), someRules(), frame);
  for (const char* text : {"1,204", "LEFT OF 20,000", "1:15.5", "BUDGET", "best 3:12.4"}) {
    EXPECT_TRUE(canvas.says(text)) << text;
  }
  EXPECT_FALSE(canvas.says("WAVE"));
  EXPECT_EQ(canvas.outside(), "");
}

TEST(PracticePanelTest, ShowsTheTypesTheChoiceAndTheKeys) {
  RememberingCanvas canvas, replay;
  drawPracticePanel(canvas, someRules(), {4, 500, true, true, {}});
  for (const char* text : {"triangle", "texel", "compute", "x 500", "N", "C", "T", "SLOW MOTION"}) {
    EXPECT_TRUE(canvas.says(text)) << text;
  }
  EXPECT_TRUE(isColour(find(canvas, "5"), theme::kGold)) << "the fifth type is chosen";
  EXPECT_FALSE(isColour(find(canvas, "4"), theme::kGold));
  EXPECT_EQ(canvas.outside(), "");
  drawPracticePanel(replay, someRules(), {4, 500, false, false, {}});
  EXPECT_TRUE(replay.says("x 500"));
  EXPECT_FALSE(replay.says("clear all"));
}

TEST(PracticePanelTest, TellsWhatThereIsToKnowOfAnEnemyWhereverItIs) {
  EntityRecord enemy{};
  enemy.id = 17;
  enemy.type = 3;
  enemy.state = uint32_t(State::avoiding);
  enemy.energy = 12.5f;
  enemy.velocity_x = 3;
  enemy.velocity_y = 4;
  enemy.timer = 30;
  enemy.cooldown = 90;
  for (const float x : {20.0f, 640.0f, 1270.0f}) {
    for (const float y : {5.0f, 360.0f, 715.0f}) {
      RememberingCanvas canvas;
      drawPracticePause(canvas, someRules(), {}, false, Inspected{enemy, x, y});
      for (const char* text :
           {"PAUSED", "vertex", "#17", "avoiding bullets", "12.5 of 30.0", "5.0 of 9.0 m/s", "0.5 s", "1.5 s"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
      }
      EXPECT_EQ(canvas.outside(), "");
    }
  }
  RememberingCanvas none;
  drawPracticePause(none, someRules(), {}, true, std::nullopt);
  EXPECT_TRUE(none.says("the controller is gone"));
  EXPECT_FALSE(none.says("state"));
}

TEST(SessionBestTest, IsKeptForEachModeAndNeverForPractice) {
  SessionBest best;
  TickReport report = reportAt(1000);
  report.score = 500;
  for (const Mode mode : kAll) {
    EXPECT_EQ(bestText(mode, best.of(mode)), "");
    best.enter(mode, report);
  }
  EXPECT_EQ(bestText(Mode::arcade, best.of(Mode::arcade)), "500");
  EXPECT_EQ(bestText(Mode::deadline, best.of(Mode::deadline)), "500");
  EXPECT_EQ(bestText(Mode::swarm, best.of(Mode::swarm)), "") << "it was not cleared";
  EXPECT_EQ(bestText(Mode::practice, best.of(Mode::practice)), "");
  report.score = 400;
  best.enter(Mode::arcade, report);
  EXPECT_EQ(best.of(Mode::arcade).score, 500u);
}

TEST(SessionBestTest, InSwarmTheShorterTimeWinsWhateverTheScore) {
  SessionBest best;
  TickReport report = reportAt(60 * 60);
  report.ending = Ending::cleared;
  best.enter(Mode::swarm, report);
  report.tick = 60 * 59;
  best.enter(Mode::swarm, report);
  EXPECT_EQ(bestText(Mode::swarm, best.of(Mode::swarm)), "0:59.0");
  report.tick = 60 * 61;
  report.score = 1000000;
  best.enter(Mode::swarm, report);
  EXPECT_EQ(bestText(Mode::swarm, best.of(Mode::swarm)), "0:59.0");
}

TEST(ModeEndTest, TimeUpSaysSoAndWhatTookTheLastOfIt) {
  TickReport report = reportAt(60 * 150);
  report.over = 1;
  report.ending = Ending::timeUp;
  report.score = 4321;
  RememberingCanvas ranOut, taken;
  drawGameOver(ranOut, after(report), someRules(), {2, {}, true, Mode::deadline, 8192});
  for (const char* text : {"TIME UP", "the clock ran out", "4,321", "first score", "2:30"}) {
    EXPECT_TRUE(ranOut.says(text)) << text;
  }
  EXPECT_FALSE(ranOut.says("FRAME DROPPED"));
  report.contactType = 2;
  report.contactCost_us = 12000;
  drawGameOver(taken, after(report), someRules(), {2, {}, true, Mode::deadline, 8192});
  EXPECT_TRUE(taken.says("a hexagon cost 3.6 s, the last of the clock"));
}

TEST(ModeEndTest, AClearedSwarmIsATimeAndALostOneSaysHowManyWereLeft) {
  TickReport report = reportAt(60 * 192 + 24);
  report.over = 1;
  report.ending = Ending::cleared;
  report.score = 987654;
  RememberingCanvas cleared, worse, lost;
  drawGameOver(cleared, after(report), someRules(), {2, {}, true, Mode::swarm, 8192});
  for (const char* text : {"CLEARED", "all 8,192", "3:12.4", "first time of this session", "987,654"}) {
    EXPECT_TRUE(cleared.says(text)) << text;
  }
  drawGameOver(worse, after(report), someRules(), {2, {1, 60 * 60}, true, Mode::swarm, 8192});
  EXPECT_TRUE(worse.says("best of this session 1:00.0"));
  report.ending = Ending::frameRate;
  report.enemies = 1204;
  drawGameOver(lost, after(report), someRules(), {2, {}, true, Mode::swarm, 8192});
  for (const char* text : {"FRAME DROPPED", "1,204 left", "of 8,192"}) EXPECT_TRUE(lost.says(text)) << text;
  EXPECT_EQ(cleared.outside() + lost.outside(), "");
}

}  // namespace
}  // namespace gw
