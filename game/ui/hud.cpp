#include "game/ui/hud.h"

#include <algorithm>
#include <cmath>

#include "game/ui/theme.h"
#include "game/ui/tick_text.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

using namespace theme;

constexpr float kMeterHeight = 12, kMeterTop = 34;

// Narrow windows get a narrower meter, so that score and counts keep their corners.
float meterWidth(const Canvas& canvas) {
  return std::clamp(canvas.width() * 0.344f, 200.0f, 440.0f);
}

// Numbers stay readable over a horde: the world fades towards the top edge.
void drawBackdrop(Canvas& canvas) {
  constexpr int kStrips = 24;
  constexpr float kStrip = 6;
  for (int i = 0; i < kStrips; ++i) {
    const float share = 1 - float(i) / kStrips;
    canvas.rectangle(0, kStrip * float(i), canvas.width(), kStrip,
                     faded(kShade, 0.78f * share * share * (3 - 2 * share)));
  }
}

Rgba budgetColour(float left) {
  return left > 0.5f ? mixed(kGold, kAccent, (left - 0.5f) * 2.5f) : mixed(kDanger, kGold, (left - 0.12f) * 3);
}

void drawMeter(Canvas& canvas, const RunMonitor& run, const Rules& rules, double realFps) {
  const TickReport& report = run.last();
  const float width = meterWidth(canvas);
  const float left = (canvas.width() - width) / 2, right = left + width;
  const float share = budgetLeft(report.frameTime_us, rules.budget);
  const float trail = budgetLeft(uint32_t(run.trailingFrameTime_us()), rules.budget);
  const Rgba colour = budgetColour(share);
  // Under a quarter the meter breathes: time is life, and it is nearly gone.
  const float pulse = share < 0.25f ? 0.7f + 0.3f * std::sin(float(report.tick) * 0.2f) : 1.0f;

  canvas.rectangle(left, kMeterTop, width, kMeterHeight, faded(kShade, 0.75f));
  if (trail > share) {
    canvas.rectangle(left + width * share, kMeterTop, width * (trail - share), kMeterHeight, faded(kDanger, 0.9f));
  }
  canvas.gradient(left, kMeterTop, width * share, kMeterHeight, faded(colour, 0.45f * pulse), faded(colour, pulse));
  // Quarters of the frame time are 30, 20 and 15 FPS.
  for (const int quarter : {1, 2, 3}) {
    canvas.rectangle(left + width * float(quarter) / 4 - 0.5f, kMeterTop + 3, 1, kMeterHeight - 6, faded(kText, 0.35f));
  }
  canvas.outline(left - 3, kMeterTop - 3, width + 6, kMeterHeight + 6, 1, faded(colour, 0.6f));
  // What bits may still give back.
  const float bank = rules.budget.bankMax_us > 0 ? float(report.bank_us) / float(rules.budget.bankMax_us) : 0;
  canvas.rectangle(left, kMeterTop + kMeterHeight + 5, width * std::min(bank, 1.0f), 2, faded(kGood, 0.45f));

  canvas.text("BUDGET", left - 16, kMeterTop + 11, style(11, kQuiet, TextAlign::right, 0.2f));
  canvas.text(oneDecimal(framesPerSecond(report.frameTime_us)) + " FPS", right + 16, kMeterTop + 12,
              style(14, colour, TextAlign::left, 0.5f));
  if (realFps <= 0) return;  // a picture has no frame rate
  canvas.text("real " + std::to_string(int(std::lround(realFps))), right + 110, kMeterTop + 12,
              style(9, kQuiet, TextAlign::left, 0));
}

// Deadline: time is all there is, so its clock stands where the budget does elsewhere.
void drawClock(Canvas& canvas, const TickReport& report, const Rules& rules, double realFps) {
  constexpr uint32_t kLast_ticks = 10 * kTicksPerSecond;
  constexpr float kWidth = 220, kTop = 58;
  const bool last = report.clock_ticks <= kLast_ticks;
  // The last seconds beat once a second.
  const float beat =
      last ? 1 - 0.45f * float(kTicksPerSecond - report.clock_ticks % kTicksPerSecond) / kTicksPerSecond : 1;
  const Rgba colour = last ? kDanger : kAccent;
  const float middle = canvas.width() / 2, whole = float(std::max(rules.deadline.clock_ticks, 1u));
  const float share = std::min(float(report.clock_ticks) / whole, 1.0f);
  canvas.text(minutesTenths(report.clock_ticks), middle, 50,
              style(last ? 38.0f : 34.0f, faded(colour, beat), TextAlign::centre, last ? 0.8f : 0.5f));
  canvas.rectangle(middle - kWidth / 2, kTop, kWidth, 4, faded(kShade, 0.75f));
  canvas.gradient(middle - kWidth / 2, kTop, kWidth * share, 4, faded(colour, 0.45f), colour);
  canvas.text("CLOCK", middle - kWidth / 2 - 16, kTop + 5, style(11, kQuiet, TextAlign::right, 0.2f));
  if (realFps <= 0) return;
  canvas.text("real " + std::to_string(int(std::lround(realFps))), middle + kWidth / 2 + 16, kTop + 5,
              style(9, kQuiet, TextAlign::left, 0));
}

void drawContact(Canvas& canvas, const RunMonitor& run, const Rules& rules, Mode mode) {
  const float fresh = run.contactFreshness();
  if (fresh <= 0) return;
  const RunMonitor::Contact& contact = run.lastContact();
  const float shown = std::min(1.0f, fresh * 3);
  const std::string name =
      contact.type < rules.enemyTypeCount ? upperCase(rules.enemies[contact.type].name) : "CONTACT";
  if (mode == Mode::deadline) {
    const uint32_t lost_ticks = clockCost_ticks(contact.cost_us, rules.deadline);
    canvas.text(name + "  -" + oneDecimal(double(lost_ticks) / kTicksPerSecond) + " s", canvas.width() / 2, 98,
                style(19, faded(kDanger, shown), TextAlign::centre, 0.7f));
    return;
  }
  canvas.text(name + "  +" + oneDecimal(contact.cost_us / 1000.0) + " ms", canvas.width() / 2, 88,
              style(19, faded(kDanger, shown), TextAlign::centre, 0.7f));
  canvas.text(
      oneDecimal(framesPerSecond(contact.before_us)) + " > " + oneDecimal(framesPerSecond(contact.after_us)) + " FPS",
      canvas.width() / 2, 112, style(11, faded(kText, shown * 0.9f), TextAlign::centre, 0.2f));
}

void drawScore(Canvas& canvas, const TickReport& report, const std::string& best) {
  const std::string score = withCommas(report.score);
  const float room = (canvas.width() - meterWidth(canvas)) / 2 - 16 - canvas.textWidth("BUDGET", 11) - 20 - kMargin;
  const float size = std::min(26.0f, 26 * room / std::max(canvas.textWidth(score, 26), 1.0f));
  canvas.text(score, kMargin, 52, style(size, kText, TextAlign::left, 0.45f));
  canvas.text(multiplierText(report.multiplierTenths), kMargin, 82, style(16, kGold, TextAlign::left, 0.4f));
  if (!best.empty()) canvas.text("best " + best, kMargin, 104, style(9, kQuiet, TextAlign::left, 0));
}

void drawCounts(Canvas& canvas, const RunMonitor& run, const HudFrame& frame) {
  const TickReport& report = run.last();
  const float right = canvas.width() - kMargin;
  const auto row = [&](float baseline, const std::string& value, const char* label, float size, Rgba colour) {
    canvas.text(value, right, baseline, style(size, colour, TextAlign::right, 0.35f));
    canvas.text(label, right - canvas.textWidth(value, size) - 12, baseline, style(9, kQuiet, TextAlign::right, 0));
  };
  if (frame.mode == Mode::swarm) {  // the time is the score, and what is left is all that matters
    row(46, minutesTenths(report.tick), "TIME", 20, kText);
    row(76, withCommas(report.enemies), ("LEFT OF " + withCommas(frame.enemies)).c_str(), 18, kGold);
    row(100, withCommas(run.dataPerSecond()) + "/s", "DATA", 12, kGood);
    return;
  }
  row(46, minutesSeconds(report.tick), "TIME", 16, kText);
  row(70, std::to_string(report.wave), frame.mode == Mode::practice ? "ASKED" : "WAVE", 12, kText);
  row(92, withCommas(report.enemies), "ENEMIES", 12, kText);
  row(114, withCommas(run.dataPerSecond()) + "/s", "DATA", 12, kGood);
  if (report.pace > 1) row(136, "x" + twoDecimals(double(report.pace)), "OVERCLOCK", 12, kDanger);
}

void drawFlushes(Canvas& canvas, const TickReport& report, const Rules& rules) {
  const float base = Canvas::kHeight - kMargin;
  canvas.text("FLUSH", kMargin, base - 1, style(11, kQuiet, TextAlign::left, 0.2f));
  float x = kMargin + canvas.textWidth("FLUSH", 11) + 22;
  for (uint32_t i = 0; i < std::max(rules.flush.most, report.flushes); ++i, x += 22) {
    const float y = base - 6.5f, half = 7.5f;
    const bool filled = i < report.flushes;
    const Rgba colour = filled ? kAccent : faded(kQuiet, 0.35f);
    if (filled) {
      canvas.triangle(x - half + 3, y, x, y - half + 3, x + half - 3, y, colour);
      canvas.triangle(x - half + 3, y, x, y + half - 3, x + half - 3, y, colour);
    }
    const float corner[5][2] = {{x - half, y}, {x, y - half}, {x + half, y}, {x, y + half}, {x - half, y}};
    for (int side = 0; side < 4; ++side) {
      canvas.line(corner[side][0], corner[side][1], corner[side + 1][0], corner[side + 1][1], 1.3f, colour);
    }
  }
}

}  // namespace

float budgetLeft(uint32_t frameTime_us, const Rules::Budget& budget) {
  const float span = float(budget.limit_us) - float(budget.start_us);
  if (span <= 0) return 0;
  return std::clamp((float(budget.limit_us) - float(frameTime_us)) / span, 0.0f, 1.0f);
}

uint32_t clockCost_ticks(uint32_t contact_us, const Rules::Deadline& deadline) {
  return contact_us * deadline.contactTicks_per_ms / 1000;
}

void drawHud(Canvas& canvas, const RunMonitor& run, const Rules& rules, const HudFrame& frame) {
  drawBackdrop(canvas);
  drawScore(canvas, run.last(), frame.best);
  if (frame.mode == Mode::deadline) {
    drawClock(canvas, run.last(), rules, frame.realFps);
  } else {
    drawMeter(canvas, run, rules, frame.realFps);
  }
  drawContact(canvas, run, rules, frame.mode);
  drawCounts(canvas, run, frame);
  drawFlushes(canvas, run.last(), rules);
  const float bottom = Canvas::kHeight - kMargin;
  if (!frame.banner.empty()) {
    canvas.text(frame.banner, canvas.width() / 2, bottom, style(13, kGold, TextAlign::centre, 0.4f));
  }
  if (frame.droppedTicks >= kTicksPerSecond) {
    canvas.text("slow machine: " + minutesSeconds(uint32_t(frame.droppedTicks)) + " of time dropped",
                canvas.width() - kMargin, bottom, style(9, kQuiet, TextAlign::right, 0));
  }
}

}  // namespace gw
