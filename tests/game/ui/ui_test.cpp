// What the screens say, on a canvas that only remembers.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "game/app/screen_flow.h"
#include "game/ui/game_over.h"
#include "game/ui/hud.h"
#include "game/ui/pause.h"
#include "game/ui/tick_text.h"
#include "game/ui/title.h"
#include "host/platform/number_format.h"
#include "tests/game/ui/remembering_canvas.h"

namespace gw {
namespace {

Rules someRules() {
  Rules rules{};
  rules.budget.start_us = 16667;
  rules.budget.limit_us = 83333;
  rules.budget.bankMax_us = 600;
  rules.flush.most = 5;
  rules.enemyTypeCount = 2;
  std::strcpy(rules.enemies[0].name, "triangle");
  std::strcpy(rules.enemies[1].name, "hexagon");
  rules.enemies[1].shape = Shape::hexagon;
  rules.enemies[1].contact_us = 12000;
  rules.enemies[1].value = 150;
  return rules;
}

TickReport reportAt(uint32_t tick) {
  TickReport report;
  report.tick = tick;
  report.frameTime_us = 16667;
  return report;
}

TEST(UiFormatTest, NumbersAsPeopleReadThem) {
  EXPECT_EQ(withCommas(0), "0");
  EXPECT_EQ(withCommas(999), "999");
  EXPECT_EQ(withCommas(1000), "1,000");
  EXPECT_EQ(withCommas(1234567), "1,234,567");
  EXPECT_EQ(withCommas(UINT64_MAX), "18,446,744,073,709,551,615");
  EXPECT_EQ(minutesSeconds(0), "0:00");
  EXPECT_EQ(minutesSeconds(59), "0:00");
  EXPECT_EQ(minutesSeconds(75 * 60), "1:15");
  EXPECT_EQ(minutesTenths(75 * 60 + 59), "1:15.9");
  EXPECT_EQ(minutesTenths(5), "0:00.0");
  EXPECT_EQ(multiplierText(10), "x1.0");
  EXPECT_EQ(multiplierText(12345), "x1,234.5");
  EXPECT_EQ(oneDecimal(framesPerSecond(16667)), "60.0");
  EXPECT_EQ(twoDecimals(1.125), "1.12");
  EXPECT_EQ(framesPerSecond(0), 0);
}

TEST(UiHudTest, TheMeterIsLinearInFrameTime) {
  const Rules::Budget budget = someRules().budget;
  EXPECT_FLOAT_EQ(budgetLeft(16667, budget), 1);
  EXPECT_FLOAT_EQ(budgetLeft(50000, budget), 0.5f);
  EXPECT_FLOAT_EQ(budgetLeft(83333, budget), 0);
  EXPECT_FLOAT_EQ(budgetLeft(200000, budget), 0);
  EXPECT_FLOAT_EQ(budgetLeft(0, budget), 1);
}

TEST(UiHudTest, TheMeterIsAsWideAsTheBudgetThatIsLeft) {
  RememberingCanvas full, half;
  RunMonitor run;
  run.add(reportAt(1));
  drawHud(full, run, someRules(), {});
  TickReport hit = reportAt(2);
  hit.frameTime_us = 50000;
  run.add(hit);
  drawHud(half, run, someRules(), {});
  ASSERT_EQ(full.gradients.size(), 1u);
  ASSERT_EQ(half.gradients.size(), 1u);
  EXPECT_FLOAT_EQ(half.gradients[0].width, full.gradients[0].width / 2);
  EXPECT_TRUE(full.says("60.0 FPS"));
  EXPECT_TRUE(half.says("20.0 FPS"));
}

TEST(UiHudTest, SaysEverythingThatIsPromised) {
  RememberingCanvas canvas;
  RunMonitor run;
  TickReport report = reportAt(60 * 75);
  report.score = 1234567;
  report.multiplierTenths = 124;
  report.enemies = 1204;
  report.wave = 7;
  report.flushes = 3;
  run.add(report);
  HudFrame frame;
  frame.realFps = 143.7;
  drawHud(canvas, run, someRules(), frame);
  for (const char* text :
       {"BUDGET", "60.0 FPS", "real 144", "1,234,567", "x12.4", "1,204", "7", "1:15", "/s", "FLUSH"}) {
    EXPECT_TRUE(canvas.says(text)) << text;
  }
  EXPECT_EQ(canvas.triangles, 2 * 3) << "one filled diamond a flush";
  EXPECT_EQ(canvas.outside(), "");
}

TEST(UiHudTest, SaysWhatHitForTwoSecondsAndNoLonger) {
  RunMonitor run;
  run.add(reportAt(99));
  TickReport hit = reportAt(100);
  hit.contactType = 1;
  hit.contactCost_us = 12000;
  hit.frameTime_us = 28667;
  run.add(hit);
  RememberingCanvas atOnce, later, gone;
  drawHud(atOnce, run, someRules(), {});
  EXPECT_TRUE(atOnce.says("HEXAGON"));
  EXPECT_TRUE(atOnce.says("+12.0 ms"));
  EXPECT_TRUE(atOnce.says("60.0 > 34.9 FPS"));
  run.add(reportAt(100 + 110));
  drawHud(later, run, someRules(), {});
  EXPECT_TRUE(later.says("HEXAGON"));
  run.add(reportAt(100 + 120));
  drawHud(gone, run, someRules(), {});
  EXPECT_FALSE(gone.says("HEXAGON"));
}

TEST(UiMonitorTest, DataPerSecondCountsKillsAndBitsOfTheLastSecond) {
  RunMonitor run;
  TickReport report;
  for (uint32_t tick = 1; tick <= 90; ++tick) {
    report.tick = tick;
    report.kills += 2;
    report.bitsTaken += 1;
    run.add(report);
  }
  EXPECT_EQ(run.dataPerSecond(), 180u);
  for (uint32_t tick = 91; tick <= 120; ++tick) {
    report.tick = tick;
    run.add(report);
  }
  EXPECT_EQ(run.dataPerSecond(), 90u);
  run.add(report);
  EXPECT_EQ(run.dataPerSecond(), 90u) << "a report of the same tick, after the end, changes nothing";
}

TEST(UiScreensTest, GameOverSaysHowItEndedAndHowToGoOn) {
  RunMonitor run;
  TickReport report = reportAt(60 * 83);
  report.score = 4321;
  report.kills = 87;
  report.multiplierTenths = 35;
  report.contactType = 1;
  report.contactCost_us = 12000;
  report.frameTime_us = 85000;
  report.over = 1;
  run.add(report);
  RememberingCanvas canvas, replay;
  drawGameOver(canvas, run, someRules(), {2, {5000}, true});
  for (const char* text : {"4,321", "1:23", "87", "x3.5", "a hexagon cost 12.0 ms", "R / ENTER: again", "5,000"}) {
    EXPECT_TRUE(canvas.says(text)) << text;
  }
  drawGameOver(replay, run, someRules(), {2, {}, false});
  EXPECT_FALSE(replay.says("again"));
}

TEST(UiScreensTest, TitleAndPauseNameTheKeys) {
  RememberingCanvas title, pause;
  drawTitle(title, {2, "cpu, 2 threads", 8192, Mode::arcade, ""});
  for (const char* text : {"GPUWARS", "PRESS ENTER", "WASD", "SPACE", "ESC", "cpu, 2 threads"}) {
    EXPECT_TRUE(title.says(text)) << text;
  }
  drawPause(pause, someRules(), {});
  for (const char* text : {"PAUSED", "resume", "hexagon", "12.0 ms", "150"}) EXPECT_TRUE(pause.says(text)) << text;
}

TEST(UiFlowTest, FromTitleToPlayToPauseToTitle) {
  Screen screen = Screen::title;
  EXPECT_EQ(advance(screen, {}), FlowEvent::none);
  EXPECT_EQ(advance(screen, {.confirm = true}), FlowEvent::startRun);
  EXPECT_EQ(screen, Screen::play);
  EXPECT_EQ(advance(screen, {.confirm = true, .retry = true, .quit = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::play) << "space and R mean other things while playing";
  EXPECT_EQ(advance(screen, {.pause = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause);
  EXPECT_EQ(advance(screen, {.pause = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::play);
  EXPECT_EQ(advance(screen, {.lostFocus = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause);
  EXPECT_EQ(advance(screen, {.quit = true}), FlowEvent::leaveRun);
  EXPECT_EQ(screen, Screen::title);
  EXPECT_EQ(advance(screen, {.pause = true}), FlowEvent::quitProgram);
}

TEST(UiFlowTest, TheSettingsLeadBackToWhereTheyWereOpened) {
  Screen screen = Screen::title;
  EXPECT_EQ(advance(screen, {.settings = true}), FlowEvent::none);
  ASSERT_EQ(screen, Screen::settings);
  EXPECT_EQ(advance(screen, {.confirm = true, .retry = true, .pause = true, .quit = true, .settings = true}),
            FlowEvent::none);
  ASSERT_EQ(screen, Screen::settings) << "only the screen itself says when it is done";
  EXPECT_EQ(advance(screen, {.settingsDone = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::title);
  screen = Screen::pause;
  advance(screen, {.settings = true});
  ASSERT_EQ(screen, Screen::settings);
  EXPECT_EQ(advance(screen, {.settingsDone = true, .inRun = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause) << "the run still waits";
  screen = Screen::play;
  advance(screen, {.settings = true});
  EXPECT_EQ(screen, Screen::play);
}

TEST(UiFlowTest, APadThatGoesPausesThePlay) {
  Screen screen = Screen::play;
  EXPECT_EQ(advance(screen, {.lostPad = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause);
  EXPECT_EQ(advance(screen, {.lostPad = true}), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause);
  RememberingCanvas gone, fine;
  drawPause(gone, someRules(), {.lostPad = true});
  drawPause(fine, someRules(), {});
  EXPECT_TRUE(gone.says("the controller is gone"));
  EXPECT_FALSE(fine.says("controller"));
}

TEST(UiFlowTest, ABotPlaysOnWithoutFocusOrPadUntilItIsPaused) {
  Screen screen = Screen::play;
  for (const FlowInput& left : {FlowInput{.lostFocus = true, .botPlays = true}, {.lostPad = true, .botPlays = true}}) {
    EXPECT_EQ(advance(screen, left), FlowEvent::none);
    EXPECT_EQ(screen, Screen::play);
  }
  advance(screen, {.pause = true, .botPlays = true});
  EXPECT_EQ(screen, Screen::pause);
  screen = Screen::play;
  advance(screen, {.lostFocus = true});
  EXPECT_EQ(screen, Screen::pause) << "a person's run waits";
}

TEST(UiFlowTest, ARunThatEndsAloneLeavesNoResultBehind) {
  Screen screen = Screen::play;
  EXPECT_EQ(advance(screen, {.runOver = true, .endsAlone = true}), FlowEvent::quitProgram);
  EXPECT_EQ(advance(screen, {.endsAlone = true}), FlowEvent::none) << "not before its end";
}

TEST(UiFlowTest, AStartButtonThatIsPauseAndConfirmDoesWhatEachScreenMeans) {
  const FlowInput start{.confirm = true, .pause = true};
  Screen screen = Screen::title;
  EXPECT_EQ(advance(screen, start), FlowEvent::startRun);
  EXPECT_EQ(advance(screen, start), FlowEvent::none);
  EXPECT_EQ(screen, Screen::pause);
  EXPECT_EQ(advance(screen, start), FlowEvent::none);
  EXPECT_EQ(screen, Screen::play);
  screen = Screen::over;
  EXPECT_EQ(advance(screen, start), FlowEvent::none) << "too early to start, and no reason to leave";
  EXPECT_EQ(screen, Screen::over);
}

TEST(UiFlowTest, TheResultCannotBeSkippedUnseenButRetryIsInstant) {
  Screen screen = Screen::play;
  EXPECT_EQ(advance(screen, {.runOver = true}), FlowEvent::none);
  ASSERT_EQ(screen, Screen::over);
  EXPECT_EQ(advance(screen, {.confirm = true, .shown_s = 0.1}), FlowEvent::none);
  ASSERT_EQ(screen, Screen::over);
  Screen again = screen;
  EXPECT_EQ(advance(again, {.retry = true, .shown_s = 0.0}), FlowEvent::startRun);
  EXPECT_EQ(advance(screen, {.confirm = true, .shown_s = 1.0}), FlowEvent::startRun);
  EXPECT_EQ(screen, Screen::play);
}

}  // namespace
}  // namespace gw
