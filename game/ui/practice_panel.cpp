#include "game/ui/practice_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "game/ui/shape_icon.h"
#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

using namespace theme;

constexpr float kWidth = 216, kRow = 22, kPadding = 14;

void drawFrame(Canvas& canvas, float left, float top, float width, float height) {
  canvas.rectangle(left, top, width, height, faded(kShade, 0.82f));
  canvas.outline(left, top, width, height, 1, faded(kAccent, 0.35f));
}

// A key and what it does.
void drawKey(Canvas& canvas, float x, float baseline, const std::string& key, const char* does) {
  canvas.text(key, x + 50, baseline, style(10, kGold, TextAlign::right, 0.2f));
  canvas.text(does, x + 60, baseline, style(10, kText, TextAlign::left, 0));
}

std::string seconds(uint32_t ticks) {
  return oneDecimal(double(ticks) / kTicksPerSecond) + " s";
}

void drawMarker(Canvas& canvas, float x, float y) {
  constexpr float kHalf = 17, kArm = 8;
  for (const float side : {-1.0f, 1.0f}) {
    for (const float end : {-1.0f, 1.0f}) {
      const float corner_x = x + side * kHalf, corner_y = y + end * kHalf;
      canvas.line(corner_x, corner_y, corner_x - side * kArm, corner_y, 2, kGold);
      canvas.line(corner_x, corner_y, corner_x, corner_y - end * kArm, 2, kGold);
    }
  }
}

void drawInspected(Canvas& canvas, const Rules& rules, const Inspected& inspected) {
  constexpr float kBox = 236, kRows = 7;
  const EntityRecord& enemy = inspected.entity;
  drawMarker(canvas, inspected.x, inspected.y);
  // Beside the enemy, on the side that has room.
  const float height = kRows * kRow + 2 * kPadding - 6;
  const bool right = inspected.x + 30 + kBox < canvas.width() - kMargin;
  const float left = std::max(right ? inspected.x + 30 : inspected.x - 30 - kBox, kMargin);
  const float top = std::clamp(inspected.y - height / 2, 130.0f, Canvas::kHeight - 70 - height);
  canvas.nextLayer();
  drawFrame(canvas, left, top, kBox, height);

  const EnemyRules& type = rules.enemies[std::min(enemy.type, kMaxEnemyTypes - 1)];
  const Rgba colour = rgbaOf(type.colour);
  float y = top + kPadding + 11;
  drawShapeIcon(canvas, type.shape, left + kPadding + 8, y - 5, 8, colour);
  canvas.text(type.name, left + kPadding + 26, y, style(13, colour, TextAlign::left, 0.4f));
  canvas.text("#" + std::to_string(enemy.id), left + kBox - kPadding, y, style(9, kQuiet, TextAlign::right, 0));
  const auto row = [&](const char* label, const std::string& value) {
    y += kRow;
    canvas.text(label, left + kPadding, y, style(10, kQuiet, TextAlign::left, 0));
    canvas.text(value, left + kBox - kPadding, y, style(10, kText, TextAlign::right, 0.1f));
  };
  row("state", enemy.state < kStates ? nameOf(State(enemy.state)) : "-");
  row("energy", oneDecimal(enemy.energy) + " of " + oneDecimal(type.energy));
  row("speed",
      oneDecimal(std::hypot(enemy.velocity_x, enemy.velocity_y)) + " of " + oneDecimal(type.speed_mps) + " m/s");
  row("timer", seconds(enemy.timer));
  row("cooldown", seconds(enemy.cooldown));
  row("machine", nameOf(type.machine));
}

}  // namespace

void drawPracticePanel(Canvas& canvas, const Rules& rules, const PracticeFrame& frame) {
  const KeyHints& keys = frame.keys;
  const float keyRows = frame.keysShown ? 4 : 0;
  const float height = (float(rules.enemyTypeCount) + 1 + keyRows) * kRow + 2 * kPadding + (frame.keysShown ? 8 : 0);
  const float left = kMargin, top = Canvas::kHeight - 64 - height;
  drawFrame(canvas, left, top, kWidth, height);

  float y = top + kPadding + 13;
  const std::string count = "x " + withCommas(frame.count);
  canvas.text("PRACTICE", left + kPadding, y, style(11, kQuiet, TextAlign::left, 0.2f));
  canvas.text(count, left + kWidth - kPadding, y, style(15, kGold, TextAlign::right, 0.4f));
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    y += kRow;
    const bool chosen = i == frame.type;
    const Rgba colour = rgbaOf(rules.enemies[i].colour);
    if (chosen) {
      canvas.gradient(left + 1, y - 16, kWidth - 2, kRow, faded(kAccent, 0.35f), faded(kAccent, 0.05f));
      canvas.rectangle(left, y - 16, 3, kRow, kGold);
    }
    canvas.text(std::to_string(i + 1), left + kPadding, y, style(11, chosen ? kGold : kQuiet, TextAlign::left, 0.2f));
    drawShapeIcon(canvas, rules.enemies[i].shape, left + kPadding + 32, y - 5, 7.5f, colour);
    canvas.text(rules.enemies[i].name, left + kPadding + 52, y,
                style(12, chosen ? colour : faded(colour, 0.75f), TextAlign::left, chosen ? 0.5f : 0));
  }
  if (frame.keysShown) {
    y += 8;
    drawKey(canvas, left, y += kRow, keys.spawn, "bring them");
    drawKey(canvas, left, y += kRow, keys.fewer + " " + keys.more, "fewer, more");
    drawKey(canvas, left, y += kRow, keys.clear, "clear all");
    drawKey(canvas, left, y += kRow, keys.slowMotion, frame.slow ? "full speed" : "slow motion");
  }
  if (frame.slow) {
    canvas.text("SLOW MOTION", canvas.width() / 2, Canvas::kHeight - kMargin,
                style(13, kGold, TextAlign::centre, 0.4f));
  }
}

void drawPracticePause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad,
                       const std::optional<Inspected>& inspected) {
  const float middle = canvas.width() / 2;
  canvas.nextLayer();
  if (inspected) drawInspected(canvas, rules, *inspected);
  canvas.rectangle(middle - 330, 122, 660, 100, faded(kShade, 0.82f));
  canvas.text("PAUSED", middle, 162, style(30, kAccent, TextAlign::centre, 0.8f));
  canvas.text(lostPad ? "the controller is gone: connect it, or press ESC to go on with the keyboard"
                      : "click on an enemy to see what it is up to",
              middle, 184, style(11, lostPad ? kDanger : kText, TextAlign::centre, 0.2f));
  canvas.text(keys.pause + ": resume     " + keys.retry + ": start again     " + keys.settings + ": settings     " +
                  keys.quit + ": title",
              middle, 208, style(10, kGold, TextAlign::centre, 0.1f));
}

}  // namespace gw
