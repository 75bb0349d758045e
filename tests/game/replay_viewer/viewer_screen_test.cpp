// What is shown around a replay, and what hand and mouse say: time bar, hints, speeds, free camera.
#include <gtest/gtest.h>

#include "game/replay_viewer/free_camera.h"
#include "game/replay_viewer/speeds.h"
#include "game/replay_viewer/time_bar.h"
#include "game/replay_viewer/viewer_help.h"
#include "game/ui/key_hints.h"
#include "render/text_font.h"
#include "tests/game/ui/remembering_canvas.h"

namespace gw::test {
namespace {

TEST(TimeBar, TellsTheTickUnderThePointerAndBack) {
  const float width = 1280;
  EXPECT_EQ(tickOnTimeBar(0, width, 600), 0u);
  EXPECT_EQ(tickOnTimeBar(28, width, 600), 0u);
  EXPECT_EQ(tickOnTimeBar(640, width, 600), 300u);
  EXPECT_EQ(tickOnTimeBar(1252, width, 600), 600u);
  EXPECT_EQ(tickOnTimeBar(5000, width, 600), 600u);
  EXPECT_TRUE(overTimeBar(640, 706, width));
  EXPECT_TRUE(overTimeBar(640, 719, width)) << "down to the edge: hands throw the mouse there";
  EXPECT_FALSE(overTimeBar(640, 680, width)) << "that is the world";
}

TEST(TimeBar, IsAsLongAsWhatWasPlayedAndSaysWhatItDoes) {
  RememberingCanvas quiet, busy;
  drawTimeBar(quiet, {.tick = 150, .ticks = 600, .cachedTo = 300});
  EXPECT_NEAR(quiet.bars[3].width, (1280 - 56) * 0.25f, 0.01f);
  EXPECT_NEAR(quiet.bars[2].width, (1280 - 56) * 0.5f, 0.01f);
  EXPECT_FALSE(quiet.says("SEEKING"));
  drawTimeBar(busy, {.tick = 150, .ticks = 600, .seekTarget = 590, .seekProgress = 0.459f, .underMouse = 600});
  EXPECT_TRUE(busy.says("SEEKING 45%"));
  EXPECT_TRUE(busy.says("0:10.0"));
  EXPECT_EQ(busy.outside(), "");
}

TEST(TimeBar, ShowsFromWhereOnItIsAnotherGame) {
  RememberingCanvas same, other;
  drawTimeBar(same, {.tick = 10, .ticks = 600});
  drawTimeBar(other, {.tick = 10, .ticks = 600, .differs = 300});
  ASSERT_EQ(other.bars.size(), same.bars.size() + 1);
  EXPECT_NEAR(other.bars[4].left, 640, 0.01f);
  EXPECT_NEAR(other.bars[4].width, 612, 0.01f);
}

TEST(ViewerHelp, NamesEveryKeyWithinThePicture) {
  RememberingCanvas canvas;
  drawViewerHelp(canvas, {});
  for (const char* key : {"SPACE", ". ,", "+ -", "LEFT RIGHT", "PAGE UP DOWN", "HOME END", "WASD", "WHEEL", "ESC"}) {
    EXPECT_TRUE(canvas.says(key)) << key;
  }
  EXPECT_EQ(canvas.outside(), "");
}

// With the typeface's own widths. 720 units are the height of every window; 960 is the width of one at 4:3.
class CanvasOfWindow final : public RememberingCanvas {
 public:
  explicit CanvasOfWindow(PixelSize window) : width_(kHeight * float(window.width) / float(window.height)) {}
  float width() const override { return width_; }
  float textWidth(std::string_view text, float size) const override {
    static const TextFont font = loadTextFont(GW_ASSETS_DIR);
    return font.width_px(text, size);
  }

 private:
  float width_;
};

TEST(ViewerHelp, LiesWithinItsBoxAndThePicture) {
  KeyHints german, long_names;
  german.faster = "US =", german.slower = "US -", german.stepBack = "US ,";
  long_names.fullscreen = long_names.mute = long_names.quit = "BRIGHTNESSDOWN";
  for (const KeyHints& keys : {KeyHints(), german, long_names}) {
    for (const PixelSize window : {PixelSize{1280, 720}, {1920, 1080}, {2560, 1080}, {800, 600}}) {
      CanvasOfWindow canvas(window);
      drawViewerHelp(canvas, keys);
      ASSERT_EQ(canvas.outlines.size(), 1u);
      const auto& box = canvas.outlines[0];
      EXPECT_EQ(canvas.outside({box.left + 8, box.top + 8, box.width - 16, box.height - 16}), "") << window.width;
      EXPECT_EQ(canvas.outside(), "");
      EXPECT_LE(box.left + box.width, canvas.width());
      EXPECT_EQ(canvas.bars[0].width, box.width);
    }
  }
}

TEST(ViewerHelp, CallsTheKeysAsTheLayoutDoes) {
  KeyHints french;
  french.stepOn = ":", french.stepBack = ";", french.slower = ")", french.pan = "ZQSD", french.mute = ",",
  french.quit = "A";
  RememberingCanvas help, hints, paused;
  drawViewerHelp(help, french);
  drawViewerHints(hints, false, french, "");
  drawViewerHints(paused, true, french, "");
  for (const char* key : {": ;", "+ )", "ZQSD, DRAG", "F ,", "ESC  A"}) EXPECT_TRUE(help.says(key)) << key;
  EXPECT_TRUE(hints.says(") + speed") && hints.says("A leave"));
  EXPECT_TRUE(paused.says(": ; tick"));
}

TEST(ViewerHelp, HintsGiveWayToALongBanner) {
  RememberingCanvas roomy, tight;
  drawViewerHints(roomy, false, {}, "");
  drawViewerHints(tight, false, {}, std::string(60, 'X'));
  EXPECT_TRUE(roomy.says("SPACE pause"));
  EXPECT_FALSE(tight.says("SPACE pause"));
  EXPECT_TRUE(tight.says("H keys"));
}

TEST(Speeds, GoUpAndDownInStepsAndStopAtTheEnds) {
  double speed = 1;
  for (const double wanted : {2.0, 4.0, 8.0, 16.0, 16.0}) EXPECT_EQ(speed = faster(speed), wanted);
  for (const double wanted : {8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.1}) EXPECT_EQ(speed = slower(speed), wanted);
  EXPECT_EQ(faster(3), 4) << "from one that --speed gave";
  EXPECT_EQ(slower(3), 2);
  EXPECT_EQ(speedText(0.1), "x1/10");
  EXPECT_EQ(speedText(0.25), "x1/4");
  EXPECT_EQ(speedText(16), "x16");
  EXPECT_EQ(speedText(1.5), "x1.50");
  EXPECT_TRUE(isHeardAt(1) && isHeardAt(0.5) && isHeardAt(2));
  EXPECT_FALSE(isHeardAt(0.25) || isHeardAt(4));
}

TEST(FreeCamera, MovesOnlyWhenItIsFreeAndStaysOverTheWorld) {
  FreeCamera camera(100, 80);
  camera.pan(1, 1);
  EXPECT_FALSE(camera.on());
  camera.free({50, 40, 40});
  camera.pan(0.5f, -0.25f);
  EXPECT_FLOAT_EQ(camera.place()->x, 70);
  EXPECT_FLOAT_EQ(camera.place()->y, 30);
  camera.pan(100, -100);
  EXPECT_FLOAT_EQ(camera.place()->x, 100);
  EXPECT_FLOAT_EQ(camera.place()->y, 0);
  camera.release();
  EXPECT_FALSE(camera.on());
}

TEST(FreeCamera, ZoomsAboutThePointerWithinLimits) {
  FreeCamera camera(100, 80);
  camera.free({50, 40, 40});
  const float before = (60 - camera.place()->x) / camera.place()->height_m;
  camera.zoom(2, 60, 40);
  EXPECT_LT(camera.place()->height_m, 40);
  EXPECT_NEAR((60 - camera.place()->x) / camera.place()->height_m, before, 1e-5f) << "what is pointed at stays";
  camera.zoom(100, 60, 40);
  EXPECT_FLOAT_EQ(camera.place()->height_m, FreeCamera::kNearest_m);
  camera.zoom(-100, 60, 40);
  EXPECT_FLOAT_EQ(camera.place()->height_m, camera.furthest_m());
}

}  // namespace
}  // namespace gw::test
