// The settings: values on the left, what is bound to what on the right.
#pragma once

#include "game/settings/settings_menu.h"
#include "game/ui/canvas.h"

namespace gw {

struct SettingsFrame {
  double now_s = 0;  // the clock that the menu is given
  bool pad = false;  // say what to press on a pad
};

void drawSettings(Canvas& canvas, const SettingsMenu& menu, const SettingsFrame& frame);

}  // namespace gw
