#include "game/ui/settings_screen.h"

#include <cmath>

#include "game/settings/rebind.h"
#include "game/settings/settings_fields.h"
#include "game/ui/theme.h"
#include "host/input/control_names.h"

namespace gw {

namespace {

using namespace theme;

constexpr float kTop = 164, kRow = 26;
constexpr float kBindingRow = 20;  // there are more of them
constexpr float kSize = 12;
// Of both columns, from the middle of the window: 4:3 windows have 480 on each side.
constexpr float kLeft = -464, kValues = -110, kRight = -60, kKeys = 84, kPad = 330, kEnd = 464;

// Cut to a width; the end is marked.
std::string fitted(const Canvas& canvas, std::string text, float size, float width) {
  if (canvas.textWidth(text, size) <= width) return text;
  while (!text.empty() && canvas.textWidth(text + "..", size) > width) text.pop_back();
  return text + "..";
}

void drawChoice(Canvas& canvas, float left, float width, float baseline) {
  canvas.gradient(left - 10, baseline - 18, width + 20, 24, faded(kAccent, 0.30f), faded(kAccent, 0.05f));
  canvas.rectangle(left - 10, baseline - 18, 2, 24, kAccent);
}

void drawValue(Canvas& canvas, const SettingsField& field, Settings settings, float right, float baseline) {
  if (field.flag) {
    const bool on = *field.flag(settings);
    canvas.text(on ? "ON" : "OFF", right, baseline, style(kSize, on ? kGood : kQuiet, TextAlign::right, 0.2f));
    return;
  }
  constexpr float kBar = 100, kNumber = 58;
  const float share = *field.number(settings) / field.most, left = right - kNumber - kBar;
  canvas.rectangle(left, baseline - 7, kBar, 3, faded(kQuiet, 0.4f));
  canvas.rectangle(left, baseline - 7, kBar * share, 3, kAccent);
  canvas.rectangle(left + kBar * share - 2, baseline - 12, 4, 13, kText);
  canvas.text(std::to_string(int(std::lround(*field.number(settings) * 100))) + "%", right, baseline,
              style(kSize, kText, TextAlign::right, 0.1f));
}

void drawValues(Canvas& canvas, const SettingsMenu& menu, float middle) {
  const float left = middle + kLeft, right = middle + kValues;
  float y = kTop;
  const auto fields = settingsFields();
  for (uint32_t i = 0; i < SettingsMenu::firstAction(); ++i) {
    if (i == SettingsMenu::resetRow()) y += kRow / 2;
    const bool chosen = menu.row() == i;
    if (chosen) drawChoice(canvas, left, right - left, y);
    const char* label = i == SettingsMenu::resetRow()  ? "reset everything"
                        : i == SettingsMenu::doneRow() ? "done"
                                                       : fields[i].label;
    canvas.text(label, left, y, style(kSize, chosen ? kGold : kText, TextAlign::left, chosen ? 0.4f : 0.1f));
    if (i < fields.size()) drawValue(canvas, fields[i], menu.settings(), right, y);
    y += kRow;
  }
}

void drawBindings(Canvas& canvas, const SettingsMenu& menu, const SettingsFrame& frame, float middle) {
  const Bindings& bindings = menu.settings().bindings;
  canvas.text("KEYS AND MOUSE", middle + kKeys, kTop - kRow, style(9, kQuiet, TextAlign::left, 0));
  canvas.text("PAD", middle + kPad, kTop - kRow, style(9, kQuiet, TextAlign::left, 0));
  float y = kTop;
  for (uint32_t i = 0; i < kActions; ++i, y += kBindingRow) {
    const Action action = Action(i);
    const bool chosen = menu.row() == SettingsMenu::firstAction() + i;
    if (chosen) drawChoice(canvas, middle + kRight, kEnd - kRight, y);
    canvas.text(actionLabel(action), middle + kRight, y,
                style(kSize, chosen ? kGold : kText, TextAlign::left, chosen ? 0.4f : 0.1f));
    if (chosen && menu.waiting()) {
      const int seconds = int(std::ceil(menu.waitsFor_s(frame.now_s)));
      canvas.text("press a key or button ... " + std::to_string(seconds), middle + kKeys, y,
                  style(kSize, kGold, TextAlign::left, 0.5f));
      continue;
    }
    std::string keys = controlLabels(bindings, InputDevice::keyboard, action);
    if (!bindings.codes(InputDevice::mouse, action).empty()) {
      keys = (keys == "-" ? "" : keys + ", ") + controlLabels(bindings, InputDevice::mouse, action);
    }
    const auto cell = [&](const std::string& text, float x, float width) {
      canvas.text(fitted(canvas, text, 10, width), middle + x, y,
                  style(10, text == "-" ? kQuiet : kText, TextAlign::left, 0.1f));
    };
    cell(keys, kKeys, kPad - kKeys - 14);
    cell(controlLabels(bindings, InputDevice::pad, action), kPad, kEnd - kPad);
  }
}

const char* legend(const SettingsMenu& menu, bool pad) {
  if (menu.waiting()) return "ESC: leave it as it was";
  if (menu.row() >= SettingsMenu::firstAction()) {
    return pad ? "A: replace     RIGHT: one more     LEFT: its defaults     LB: values     B: back"
               : "ENTER: replace     RIGHT: one more     LEFT: its defaults     TAB: values     ESC: back";
  }
  return pad ? "LEFT, RIGHT: change     A: switch, choose     LB: keys     B: back"
             : "LEFT, RIGHT: change     ENTER: switch, choose     TAB: keys     ESC: back";
}

}  // namespace

void drawSettings(Canvas& canvas, const SettingsMenu& menu, const SettingsFrame& frame) {
  const float middle = canvas.width() / 2;
  canvas.nextLayer();
  canvas.rectangle(0, 0, canvas.width(), Canvas::kHeight, faded(kShade, 0.88f));
  canvas.nextLayer();
  canvas.text("SETTINGS", middle, 92, style(36, kAccent, TextAlign::centre, 0.8f));
  drawValues(canvas, menu, middle);
  drawBindings(canvas, menu, frame, middle);
  canvas.text(fitted(canvas, menu.note(), 12, 2 * kEnd), middle, 636, style(12, kGold, TextAlign::centre, 0.3f));
  canvas.text(legend(menu, frame.pad), middle, 676, style(10, kQuiet, TextAlign::centre, 0.1f));
}

}  // namespace gw
