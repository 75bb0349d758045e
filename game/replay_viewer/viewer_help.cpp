#include "game/replay_viewer/viewer_help.h"

#include <algorithm>

#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

using namespace theme;

void drawViewerHints(Canvas& canvas, bool paused, const KeyHints& keys, const std::string& banner) {
  const std::string few = keys.help + " keys";
  const std::string all = (paused ? "SPACE play   " + keys.stepOn + " " + keys.stepBack + " tick"
                                  : "SPACE pause   " + keys.slower + " " + keys.faster + " speed") +
                          "   ARROWS 5 s   " + keys.camera + " camera   " + few + "   " + keys.quit + " leave";
  const float room = (canvas.width() - canvas.textWidth(banner, 13)) / 2 - kMargin - 24;
  const std::string& shown = canvas.textWidth(all, 9) <= room ? all : few;
  canvas.text(shown, canvas.width() - kMargin, Canvas::kHeight - kMargin - 1, style(9, kQuiet, TextAlign::right, 0));
}

void drawPausedTag(Canvas& canvas, uint32_t tick) {
  const float middle = canvas.width() / 2;
  canvas.text("PAUSED", middle, 138, style(26, kAccent, TextAlign::centre, 0.7f));
  canvas.text("tick " + withCommas(tick), middle, 158, style(11, kText, TextAlign::centre, 0.2f));
}

void drawViewerHelp(Canvas& canvas, const KeyHints& keys) {
  constexpr float kRow = 24, kTop = 170, kPadding = 16, kBetween = 16, kKeySize = 11, kTextSize = 10;
  struct Line {
    std::string key;
    const char* does;
  };
  const Line lines[] = {
      {"SPACE", "play, pause"},
      {keys.stepOn + " " + keys.stepBack, "one tick on, back"},
      {keys.faster + " " + keys.slower, "faster, slower"},
      {"LEFT RIGHT", "5 s back, on"},
      {"PAGE UP DOWN", "1 min back, on; or SHIFT LEFT RIGHT"},
      {"HOME END", "start, end"},
      {"MOUSE", "click or drag on the bar"},
      {keys.camera, "camera: free, or with the ship"},
      {keys.pan + ", DRAG", "move the free camera"},
      {"WHEEL", "zoom it"},
      {keys.ship, "back to the ship"},
      {keys.fullscreen + " " + keys.mute, "full screen, mute"},
      {"F3 F4 F5", "figures, colours by row, other broad phase"},
      {keys.help, "hide the keys"},
      {keys.pause + "  " + keys.quit, "pause; leave"},
  };
  float keyWidth = 0, textWidth = 0;
  for (const Line& line : lines) {
    keyWidth = std::max(keyWidth, canvas.textWidth(line.key, kKeySize));
    textWidth = std::max(textWidth, canvas.textWidth(line.does, kTextSize));
  }
  const float left = kMargin - 8, width = keyWidth + textWidth + kBetween + 2 * kPadding;
  const float height = 44 + kRow * float(std::size(lines)), column = left + kPadding + keyWidth;
  canvas.nextLayer();
  canvas.rectangle(left, kTop, width, height, faded(kShade, 0.86f));
  canvas.outline(left, kTop, width, height, 1, faded(kAccent, 0.4f));
  float y = kTop + 34;
  for (const Line& line : lines) {
    canvas.text(line.key, column, y, style(kKeySize, kGold, TextAlign::right, 0.25f));
    canvas.text(line.does, column + kBetween, y, style(kTextSize, kText, TextAlign::left, 0.05f));
    y += kRow;
  }
}

}  // namespace gw
