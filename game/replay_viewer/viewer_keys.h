// Keys and mouse while a replay is watched. They are fixed, by place as all keys (bindings.h), and come first; the
// game's own bindings (pause, quit, full screen, mute) get what is left.
#pragma once

#include <SDL_events.h>

#include <cstdint>
#include <optional>

namespace gw {

struct ViewerPresses {
  int pauses = 0, helps = 0;
  int ticks = 0;    // steps on, less those back
  int speeds = 0;   // steps faster, less those slower
  int seconds = 0;  // on, less back
  bool home = false, end = false;
  bool freeCamera = false, followShip = false;
  int wheel = 0;
  bool clicked = false;            // the left button went down, and where
  float click_x = 0, click_y = 0;  // px
  float drag_x = 0, drag_y = 0;    // pixels with the left button held
};

class ViewerKeys {
 public:
  // True when it was one of these.
  bool handle(const SDL_Event& event);
  // Since the last call.
  ViewerPresses take();

  // Held: -1, 0 or 1, y up.
  int pan_x() const { return int(held_[3]) - int(held_[1]); }
  int pan_y() const { return int(held_[0]) - int(held_[2]); }
  bool buttonHeld() const { return button_; }
  float pointer_x_px() const { return x_; }
  float pointer_y_px() const { return y_; }
  bool pointerSeen() const { return seen_; }

 private:
  bool press(const SDL_Keysym& key);

  ViewerPresses presses_;
  bool held_[4] = {};  // as kViewerPan
  bool button_ = false, seen_ = false;
  float x_ = 0, y_ = 0;
};

}  // namespace gw
