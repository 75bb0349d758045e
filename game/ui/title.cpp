#include "game/ui/title.h"

#include <cmath>

#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

using namespace theme;

struct Hint {
  const std::string& keys;
  const char* does;
};

// "WASD move   ARROWS or MOUSE aim and fire   ..." in two colours, as one centred line.
void drawControls(Canvas& canvas, const KeyHints& keys, float baseline) {
  const Hint hints[] = {{keys.move, "move"},   {keys.aim, "aim and fire"},  {keys.flush, "flush"},
                        {keys.pause, "pause"}, {keys.settings, "settings"}, {keys.fullscreen, "fullscreen"}};
  constexpr float kSize = 11, kBetween = 9, kApart = 30;
  float total = -kApart;
  for (const Hint& control : hints) {
    total += canvas.textWidth(control.keys, kSize) + kBetween + canvas.textWidth(control.does, kSize) + kApart;
  }
  float x = (canvas.width() - total) / 2;
  for (const Hint& control : hints) {
    canvas.text(control.keys, x, baseline, style(kSize, kAccent, TextAlign::left, 0.3f));
    x += canvas.textWidth(control.keys, kSize) + kBetween;
    canvas.text(control.does, x, baseline, style(kSize, kText, TextAlign::left, 0.1f));
    x += canvas.textWidth(control.does, kSize) + kApart;
  }
}

}  // namespace

void drawTitle(Canvas& canvas, const TitleFrame& frame) {
  const float middle = canvas.width() / 2;
  canvas.rectangle(0, 0, canvas.width(), Canvas::kHeight, faded(kShade, 0.35f));
  canvas.nextLayer();

  // The sign switches on like a tube: a few flickers in the first second, then steady.
  const double t = frame.time_s;
  const bool lit = t > 0.75 || std::fmod(t * 7.3, 1.0) > 0.35;
  TextStyle sign = style(92, faded(kAccent, lit ? 1.0f : 0.25f), TextAlign::centre, lit ? 0.9f : 0.1f);
  sign.weight = 0.27f;
  canvas.text("GPUWARS", middle, 290, sign);
  canvas.gradient(middle - 330, 322, 330, 2, faded(kAccent, 0), faded(kAccent, 0.8f));
  canvas.gradient(middle, 322, 330, 2, faded(kAccent, 0.8f), faded(kAccent, 0));
  canvas.text("process everything. keep the frame rate alive.", middle, 360,
              style(14, kText, TextAlign::centre, 0.25f));

  drawModeChoice(canvas, frame.mode, 418);

  const float pulse = 0.65f + 0.35f * float(std::sin(t * 3.2));
  canvas.text("PRESS " + frame.keys.confirm, middle, 508, style(22, faded(kGold, pulse), TextAlign::centre, 0.6f));
  canvas.text(frame.keys.confirmToo, middle, 534, style(10, kQuiet, TextAlign::centre, 0));
  if (!frame.best.empty()) {
    canvas.text("best " + frame.best, middle, 574, style(14, kText, TextAlign::centre, 0.3f));
  }

  drawControls(canvas, frame.keys, Canvas::kHeight - 76);
  canvas.text("up to " + withCommas(frame.enemies) + " enemies on " + frame.device, middle, Canvas::kHeight - 36,
              style(9, kQuiet, TextAlign::centre, 0));
}

}  // namespace gw
