#include "game/settings/settings_menu.h"

#include <algorithm>
#include <cmath>

#include "game/settings/rebind.h"
#include "game/settings/settings_fields.h"

namespace gw {

namespace {

constexpr float kSteps = 20;  // a press changes a number by 1/20
constexpr double kWait_s = 5;

}  // namespace

uint32_t SettingsMenu::resetRow() {
  return uint32_t(settingsFields().size());
}
uint32_t SettingsMenu::doneRow() {
  return resetRow() + 1;
}
uint32_t SettingsMenu::firstAction() {
  return doneRow() + 1;
}
uint32_t SettingsMenu::rows() {
  return firstAction() + kActions;
}

void SettingsMenu::press(const MenuPresses& presses, double now_s) {
  if (waiting_) {
    if (presses.escape || now_s >= waitsUntil_s_) {
      waiting_.reset();
      note_ = "nothing was changed";
    }
    return;
  }
  if (presses.back) {
    done_ = true;
    return;
  }
  const int steps = presses.down - presses.up;
  const int count = int(rows());
  if (steps != 0) row_ = uint32_t(((int(row_) + steps) % count + count) % count);
  if (presses.otherColumn) row_ = row_ < firstAction() ? firstAction() : 0;
  if (steps != 0 || presses.otherColumn) note_.clear();

  const int by = presses.right - presses.left;
  if (row_ >= firstAction()) {
    const Action action = Action(row_ - firstAction());
    if (by > 0) waitFor(action, true, now_s);
    if (by < 0) {
      const Bindings defaults;
      for (uint32_t device = 0; device < kInputDevices; ++device) {
        settings_.bindings.codes(InputDevice(device), action) = defaults.codes(InputDevice(device), action);
      }
      note_ = actionLabel(action) + " has its defaults back";
    }
  } else if (by != 0) {
    change(by);
  }
  if (presses.confirm) confirm(now_s);
}

void SettingsMenu::change(int by) {
  if (row_ >= resetRow()) return;
  const SettingsField& field = settingsFields()[row_];
  if (field.flag) {
    if (by % 2 != 0) *field.flag(settings_) = !*field.flag(settings_);
    return;
  }
  float& number = *field.number(settings_);
  number = std::clamp((std::round(number * kSteps) + float(by)) / kSteps, 0.0f, field.most);
}

void SettingsMenu::confirm(double now_s) {
  if (row_ >= firstAction()) {
    if (!waiting_) waitFor(Action(row_ - firstAction()), false, now_s);
  } else if (row_ == doneRow()) {
    done_ = true;
  } else if (row_ == resetRow()) {
    settings_ = Settings();
    note_ = "everything has its default back";
  } else if (settingsFields()[row_].flag) {
    change(1);
  }
}

void SettingsMenu::waitFor(Action action, bool add, double now_s) {
  waiting_ = Wait{action, add};
  waitsUntil_s_ = now_s + kWait_s;
  note_.clear();
}

void SettingsMenu::hear(Control control) {
  if (!waiting_) return;
  note_ = rebind(settings_.bindings, waiting_->action, control, waiting_->add);
  waiting_.reset();
}

}  // namespace gw
