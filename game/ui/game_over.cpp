#include "game/ui/game_over.h"

#include <algorithm>
#include <cmath>

#include "game/ui/hud.h"
#include "game/ui/shape_icon.h"
#include "game/ui/theme.h"
#include "game/ui/tick_text.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

using namespace theme;

// "a hexagon cost 12.0 ms", in deadline "a hexagon cost 3.6 s".
std::string contactText(const RunMonitor::Contact& contact, const Rules& rules, Mode mode) {
  const std::string name = rules.enemies[contact.type].name;
  const std::string cost =
      mode == Mode::deadline
          ? oneDecimal(double(clockCost_ticks(contact.cost_us, rules.deadline)) / kTicksPerSecond) + " s"
          : oneDecimal(contact.cost_us / 1000.0) + " ms";
  return std::string(name.find_first_of("aeiou") == 0 ? "an " : "a ") + name + " cost " + cost;
}

struct Headline {
  const char* text;
  Rgba colour;
  std::string cause;
};

Headline headline(const RunMonitor& run, const Rules& rules, const GameOverFrame& frame) {
  const TickReport& report = run.last();
  const RunMonitor::Contact& contact = run.lastContact();
  const bool known = contact.type < rules.enemyTypeCount;
  if (report.ending == Ending::cleared) {
    return {"CLEARED", kGood, "all " + withCommas(frame.enemies) + " of them are processed"};
  }
  if (report.ending == Ending::timeUp) {
    const bool atOnce = known && contact.tick == report.tick;
    return {"TIME UP", kGold,
            atOnce ? contactText(contact, rules, frame.mode) + ", the last of the clock" : "the clock ran out"};
  }
  const std::string limit = oneDecimal(framesPerSecond(rules.budget.limit_us)) + " FPS";
  return {"FRAME DROPPED", kDanger,
          known ? contactText(contact, rules, frame.mode) + ": under " + limit : "the frame rate fell under " + limit};
}

// The number that counts, and under it what it is. In swarm that is the time, or how far it came.
void drawResult(Canvas& canvas, const TickReport& report, const GameOverFrame& frame) {
  const float middle = canvas.width() / 2;
  const bool swarm = frame.mode == Mode::swarm;
  const bool best = frame.canRetry && beats(frame.mode, report, frame.best);
  const std::string before = bestText(frame.mode, frame.best), kind = swarm ? "time" : "score";
  const std::string value = !swarm                             ? withCommas(report.score)
                            : report.ending == Ending::cleared ? minutesTenths(report.tick)
                                                               : withCommas(report.enemies) + " left";
  std::string under = kind;
  if (best) {
    under = before.empty() ? "first " + kind + " of this session" : "new best of this session";
  } else if (!before.empty()) {
    under = "best of this session " + before;
  } else if (swarm && report.ending != Ending::cleared) {
    under = "of " + withCommas(frame.enemies);
  }
  canvas.text(value, middle, 312, style(52, best ? kGold : kText, TextAlign::centre, 0.7f));
  canvas.text(under, middle, 342, style(11, best ? kGold : kQuiet, TextAlign::centre, 0.2f));
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

  const Headline head = headline(run, rules, frame);
  canvas.text(head.text, middle, 168, style(44, faded(head.colour, shown), TextAlign::centre, 0.8f));
  canvas.text(head.cause, middle, 206, style(14, faded(kText, shown), TextAlign::centre, 0.2f));
  drawResult(canvas, report, frame);

  const auto figure = [&](float x, const std::string& value, const char* label) {
    canvas.text(value, x, 410, style(22, kText, TextAlign::centre, 0.35f));
    canvas.text(label, x, 434, style(10, kQuiet, TextAlign::centre, 0));
  };
  figure(middle - 300, minutesSeconds(report.tick), "survived");
  figure(middle - 100, withCommas(report.kills), "processed");
  figure(middle + 100, multiplierText(report.multiplierTenths), "multiplier");
  if (frame.mode == Mode::swarm) {
    figure(middle + 300, withCommas(report.score), "score");
  } else {
    figure(middle + 300, std::to_string(report.wave), "wave");
  }
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
