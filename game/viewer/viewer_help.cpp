#include "game/viewer/viewer_help.h"

#include "game/ui/format.h"
#include "game/ui/theme.h"

namespace gw {

using namespace theme;

void drawViewerHints(Canvas& canvas, bool paused, const KeyHints& keys, const std::string& banner) {
  const std::string all = std::string(paused ? "SPACE play   . , tick" : "SPACE pause   - + speed") +
                          "   ARROWS 5 s   C camera   H keys   " + keys.quit + " leave";
  const std::string few = "H keys";
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
  constexpr float kWidth = 420, kRow = 24, kTop = 170;
  struct Line {
    std::string key;
    const char* does;
  };
  const Line lines[] = {
      {"SPACE", "play, pause"},
      {". ,", "one tick on, back"},
      {"+ -", "faster, slower"},
      {"LEFT RIGHT", "5 s back, on"},
      {"PAGE UP DOWN", "1 min back, on; or SHIFT LEFT RIGHT"},
      {"HOME END", "start, end"},
      {"MOUSE", "click or drag on the bar"},
      {"C", "camera: free, or with the ship"},
      {"WASD, DRAG", "move the free camera"},
      {"WHEEL", "zoom it"},
      {"0", "back to the ship"},
      {keys.fullscreen + " M", "full screen, mute"},
      {"F3 F4 F5", "figures, colours by row, other broad phase"},
      {"H", "hide the keys"},
      {keys.pause + "  " + keys.quit, "pause; leave"},
  };
  const float left = kMargin - 8, height = 44 + kRow * float(std::size(lines));
  canvas.nextLayer();
  canvas.rectangle(left, kTop, kWidth, height, faded(kShade, 0.86f));
  canvas.outline(left, kTop, kWidth, height, 1, faded(kAccent, 0.4f));
  float y = kTop + 34;
  for (const Line& line : lines) {
    canvas.text(line.key, left + 134, y, style(11, kGold, TextAlign::right, 0.25f));
    canvas.text(line.does, left + 150, y, style(10, kText, TextAlign::left, 0.05f));
    y += kRow;
  }
}

}  // namespace gw
