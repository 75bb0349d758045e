// What moves about in menus, whatever is bound to what: arrow keys, Enter and Escape; a pad's cross and left stick,
// A and B. So no binding locks players out of the settings.
#pragma once

#include <SDL_events.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "host/input/pad_arbiter.h"

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
  // A press of a pad out of its turn is none.
  void handle(const SDL_Event& event, PadArbiter& turns);

  // The presses since the last call. Held arrows repeat as the keyboard repeats them, a held cross or stick after
  // 0.4 s and then every 0.08 s; `now_s` is the time for that.
  MenuPresses take(double now_s);

 private:
  struct Direction {
    int x = 0, y = 0;  // y down
    friend bool operator==(const Direction&, const Direction&) = default;
  };
  struct Pad {
    SDL_JoystickID id = 0;
    Direction stick, cross;  // held
  };
  Pad& pad(SDL_JoystickID id);
  Direction held() const;
  static Direction changed(Direction before, Direction now);
  void pressButton(const SDL_ControllerButtonEvent& event, PadArbiter& turns);
  void moveStick(const SDL_ControllerAxisEvent& event, PadArbiter& turns);
  void step(Direction direction);

  MenuPresses presses_;
  std::vector<Pad> pads_;
  std::optional<SDL_JoystickID> last_;  // the pad that pressed last: what it holds repeats
  Direction repeated_;
  double repeatAt_s_ = 0;
};

}  // namespace gw
