// What moves about in menus, whatever is bound to what: arrow keys, Enter and Escape; a pad's cross and left stick,
// A and B. So nobody can bind his way out of the settings.
#pragma once

#include <SDL_events.h>

#include <cstdint>

namespace gw {

struct MenuPresses {
  int up = 0, down = 0, left = 0, right = 0;  // how often
  bool confirm = false;                       // Enter, A
  bool escape = false;                        // Escape
  bool back = false;                          // Escape, B
  bool otherColumn = false;                   // Tab, a shoulder button
};

class MenuKeys {
 public:
  void handle(const SDL_Event& event);

  // The presses since the last call. Held arrows repeat as the keyboard repeats them, a held cross or stick after
  // 0.4 s and then every 0.08 s; `now_s` is the time for that.
  MenuPresses take(double now_s);

 private:
  struct Direction {
    int x = 0, y = 0;  // y down
    friend bool operator==(const Direction&, const Direction&) = default;
  };
  void step(Direction direction);

  MenuPresses presses_;
  Direction stick_, cross_;  // held on any pad
  Direction repeated_;
  double repeatAt_s_ = 0;
};

}  // namespace gw
