// One line on the picture for a moment: what a key has done.
#pragma once

#include <string>

#include "game/ui/canvas.h"

namespace gw {

class Notice {
 public:
  static constexpr double kShown_s = 2;

  // Takes the place of what is still shown.
  void say(std::string text, double now_s);
  // Nothing once its time is over; it fades in the last part of it.
  void draw(Canvas& canvas, double now_s) const;

 private:
  std::string text_;
  double until_s_ = 0;
};

}  // namespace gw
