// Full screen as it is, which may be something else than what was asked for: window managers take their time, and
// without one nothing may happen at all although SDL reports success.
#pragma once

namespace gw {

class FullscreenSwitch {
 public:
  static constexpr double kPatience_s = 1;

  // The window was asked to fill the screen, or to leave it.
  void ask(bool on, double now_s) {
    asked_ = on;
    waiting_ = true;
    until_s_ = now_s + kPatience_s;
  }

  // Each frame, with what the window is. True once when what was asked for has not happened.
  bool look(bool filling, double now_s) {
    filling_ = filling;
    if (!waiting_) return false;
    if (filling == asked_) return waiting_ = false;
    if (now_s < until_s_) return false;
    waiting_ = false;
    return true;
  }

  // As asked while it may still happen, then as it is.
  bool on() const { return waiting_ ? asked_ : filling_; }

 private:
  bool asked_ = false, waiting_ = false, filling_ = false;
  double until_s_ = 0;
};

}  // namespace gw
