#include "game/ui/mode_choice.h"

#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

using namespace theme;

struct ModeText {
  std::string_view name, line;
};
constexpr ModeText kTexts[] = {{"arcade", "wave after wave: how long does your frame rate last?"},
                               {"deadline", "three minutes, twice the waves; every contact costs seconds"},
                               {"swarm", "all of them at once: process the last one as soon as you can"},
                               {"practice", "choose who comes and how many; slow motion, no end, no score to beat"}};
static_assert(std::size(kTexts) == kModeCount);

}  // namespace

std::string_view modeName(Mode mode) {
  return kTexts[uint32_t(mode)].name;
}

std::string_view modeLine(Mode mode) {
  return kTexts[uint32_t(mode)].line;
}

Mode modeBeside(Mode mode, int steps) {
  constexpr int kCount = int(kModeCount);
  return Mode((((int(mode) + steps) % kCount) + kCount) % kCount);
}

void drawModeChoice(Canvas& canvas, Mode chosen, float baseline) {
  constexpr float kSize = 16, kApart = 44;
  float total = -kApart;
  for (const ModeText& text : kTexts) total += canvas.textWidth(upperCase(std::string(text.name)), kSize) + kApart;
  const float middle = canvas.width() / 2, arrow = baseline - 6;
  float x = middle - total / 2;
  for (const float side : {-1.0f, 1.0f}) {
    const float tip = middle + side * (total / 2 + 36), back = tip - side * 9;
    canvas.triangle(tip, arrow, back, arrow - 7, back, arrow + 7, faded(kGold, 0.9f));
  }
  for (uint32_t i = 0; i < kModeCount; ++i) {
    const bool marked = Mode(i) == chosen;
    const std::string name = upperCase(std::string(kTexts[i].name));
    const float width = canvas.textWidth(name, kSize);
    canvas.text(name, x, baseline,
                style(kSize, marked ? kGold : faded(kQuiet, 0.9f), TextAlign::left, marked ? 0.6f : 0));
    if (marked) canvas.rectangle(x, baseline + 7, width, 2, kGold);
    x += width + kApart;
  }
  canvas.text(modeLine(chosen), middle, baseline + 32, style(12, kText, TextAlign::centre, 0.15f));
}

}  // namespace gw
