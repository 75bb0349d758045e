#include "game/replay_viewer/time_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "game/ui/theme.h"
#include "game/ui/tick_text.h"

namespace gw {

using namespace theme;

namespace {

constexpr float kTop = 703, kThick = 6, kSlack = 9;

float placeOf(uint32_t tick, uint32_t ticks, float width) {
  const float share = float(std::min(tick, ticks)) / float(std::max(ticks, 1u));
  return kMargin + share * (width - 2 * kMargin);
}

}  // namespace

bool overTimeBar(float x, float y, float canvasWidth) {
  return x >= kMargin - kSlack && x <= canvasWidth - kMargin + kSlack && y >= kTop - kSlack;
}

uint32_t tickOnTimeBar(float x, float canvasWidth, uint32_t ticks) {
  const float share = std::clamp((x - kMargin) / std::max(canvasWidth - 2 * kMargin, 1.0f), 0.0f, 1.0f);
  return uint32_t(std::lround(double(share) * ticks));
}

void drawTimeBar(Canvas& canvas, const TimeBarFrame& frame) {
  const float width = canvas.width(), left = kMargin;
  const auto at = [&](uint32_t tick) { return placeOf(tick, frame.ticks, width); };
  const auto part = [&](uint32_t from, uint32_t to, Rgba colour) {
    canvas.rectangle(at(from), kTop, std::max(at(to) - at(from), 0.0f), kThick, colour);
  };
  canvas.nextLayer();
  canvas.rectangle(left - 2, kTop - 2, width - 2 * kMargin + 4, kThick + 4, faded(kShade, 0.85f));
  part(0, frame.ticks, faded(kQuiet, 0.22f));
  part(0, frame.cachedTo, faded(kQuiet, 0.45f));
  part(0, frame.tick, faded(kAccent, 0.95f));
  if (frame.differs) part(*frame.differs, frame.ticks, faded(kDanger, 0.8f));
  canvas.rectangle(at(frame.tick) - 2, kTop - 4, 4, kThick + 8, kText);
  if (frame.seekTarget) canvas.rectangle(at(*frame.seekTarget) - 1.5f, kTop - 4, 3, kThick + 8, kGold);
  if (frame.underMouse) {
    const std::string time = minutesTenths(*frame.underMouse);
    const float half = canvas.textWidth(time, 12) / 2 + 8;
    const float x = std::clamp(at(*frame.underMouse), left + half, width - left - half);
    canvas.rectangle(x - half, kTop - 52, 2 * half, 20, faded(kShade, 0.9f));
    canvas.text(time, x, kTop - 37, style(12, kText, TextAlign::centre, 0.2f));
  }
  if (!frame.seekTarget) return;
  const auto percent = int(std::clamp(frame.seekProgress, 0.0f, 1.0f) * 100);
  canvas.text("SEEKING " + std::to_string(percent) + "%", width / 2, 330, style(30, kGold, TextAlign::centre, 0.7f));
}

}  // namespace gw
