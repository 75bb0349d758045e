// The settings screen without its picture: which row is chosen, and what presses make of the settings.
#pragma once

#include <optional>
#include <string>

#include "game/input/menu_keys.h"
#include "game/settings/settings.h"

namespace gw {

class SettingsMenu {
 public:
  // The first column holds the fields of settings_fields.h, then kReset and kDone; the second one row an action.
  explicit SettingsMenu(const Settings& settings) : settings_(settings) {}

  // The presses of a frame. On a value left and right change it and confirm switches it; on an action confirm asks for
  // another control, right for one more, left gives it its defaults back.
  void press(const MenuPresses& presses, double now_s);

  // An action waits for a control: the next one pressed belongs into hear(). Escape, or 5 s, end the wait.
  bool waiting() const { return waiting_.has_value(); }
  void hear(Control control);
  double waitsFor_s(double now_s) const { return waitsUntil_s_ - now_s; }

  // The window, or the sound, was switched by its own key meanwhile.
  void setFullscreen(bool on) { settings_.video.fullscreen = on; }
  void setMuted(bool on) { settings_.sound.muted = on; }

  bool done() const { return done_; }
  const Settings& settings() const { return settings_; }

  uint32_t row() const { return row_; }
  const std::string& note() const { return note_; }  // about the last change; may be empty

  static uint32_t rows();  // both columns
  static uint32_t resetRow();
  static uint32_t doneRow();
  static uint32_t firstAction();

 private:
  struct Wait {
    Action action;
    bool add;
  };
  void change(int by);
  void confirm(double now_s);
  void waitFor(Action action, bool add, double now_s);

  Settings settings_;
  uint32_t row_ = 0;
  std::optional<Wait> waiting_;
  double waitsUntil_s_ = 0;
  std::string note_;
  bool done_ = false;
};

}  // namespace gw
