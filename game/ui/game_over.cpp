#include "game/ui/game_over.h"

#include <algorithm>
#include <cmath>

#include "game/ui/format.h"
#include "game/ui/shape_icon.h"
#include "game/ui/theme.h"

namespace gw {

namespace {

using namespace theme;

std::string causeText(const RunMonitor& run, const Rules& rules) {
  const RunMonitor::Contact& contact = run.lastContact();
  const std::string limit = oneDecimal(framesPerSecond(rules.budget.limit_us)) + " FPS";
  if (contact.type >= rules.enemyTypeCount) return "the frame rate fell under " + limit;
  const std::string name = rules.enemies[contact.type].name;
  return std::string(name.find_first_of("aeiou") == 0 ? "an " : "a ") + name + " cost " +
         oneDecimal(contact.cost_us / 1000.0) + " ms: under " + limit;
}

// Kills by type as small columns of shape, number and name.
void drawKills(Canvas& canvas, const TickReport& report, const Rules& rules, float baseline) {
  constexpr float kColumn = 118;
  float x = canvas.width() / 2 - kColumn * float(rules.enemyTypeCount - 1) / 2;
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i, x += kColumn) {
    const Rgba colour = rgbaOf(rules.enemies[i].colour);
    drawShapeIcon(canvas, rules.enemies[i].shape, x, baseline - 28, 8, colour);
    canvas.text(withCommas(report.killsByType[i]), x, baseline, style(14, colour, TextAlign::centre, 0.4f));
    canvas.text(rules.enemies[i].name, x, baseline + 20, style(9, kQuiet, TextAlign::centre, 0));
  }
}

}  // namespace

void drawGameOver(Canvas& canvas, const RunMonitor& run, const Rules& rules, const GameOverFrame& frame) {
  const TickReport& report = run.last();
  const float middle = canvas.width() / 2;
  const auto shown = float(std::clamp(frame.time_s / 0.35, 0.0, 1.0));
  canvas.nextLayer();
  canvas.rectangle(0, 0, canvas.width(), Canvas::kHeight, faded(kShade, 0.8f * shown));
  canvas.nextLayer();

  canvas.text("FRAME DROPPED", middle, 168, style(44, faded(kDanger, shown), TextAlign::centre, 0.8f));
  canvas.text(causeText(run, rules), middle, 206, style(14, faded(kText, shown), TextAlign::centre, 0.2f));

  const bool best = frame.canRetry && report.score > frame.best;
  canvas.text(withCommas(report.score), middle, 312, style(52, best ? kGold : kText, TextAlign::centre, 0.7f));
  const std::string under = best ? (frame.best == 0 ? "first score of this session" : "new best of this session")
                            : frame.best > 0 ? "best of this session " + withCommas(frame.best)
                                             : "score";
  canvas.text(under, middle, 342, style(11, best ? kGold : kQuiet, TextAlign::centre, 0.2f));

  const auto figure = [&](float x, const std::string& value, const char* label) {
    canvas.text(value, x, 410, style(22, kText, TextAlign::centre, 0.35f));
    canvas.text(label, x, 434, style(10, kQuiet, TextAlign::centre, 0));
  };
  figure(middle - 300, minutesSeconds(report.tick), "survived");
  figure(middle - 100, withCommas(report.kills), "processed");
  figure(middle + 100, multiplierText(report.multiplierTenths), "multiplier");
  figure(middle + 300, std::to_string(report.wave), "wave");
  drawKills(canvas, report, rules, 506);

  if (frame.canRetry) {
    const float pulse = 0.65f + 0.35f * float(std::sin(frame.time_s * 3.2));
    canvas.text(frame.keys.retry + " / " + frame.keys.confirm + ": again", middle, 600,
                style(20, faded(kGold, pulse), TextAlign::centre, 0.6f));
  }
  canvas.text(frame.keys.pause + (frame.canRetry ? ": title" : ": leave"), middle, 632,
              style(11, kQuiet, TextAlign::centre, 0.1f));
}

}  // namespace gw
