// A pad's events through the game's own input code: what a hand with two analogue sticks sends.
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "game/input/player_input.h"
#include "tests/replays/events.h"
#include "tests/replays/script.h"

namespace gw {

namespace {

// From -32,768 to 32,767 and back in `period` ticks: sticks rest nowhere and meet both ends of their range.
int swing(uint32_t tick, uint32_t period) {
  const int phase = int(tick % period), half = int(period / 2);
  const int rise = phase < half ? phase : int(period) - phase;
  return std::clamp(rise * 65536 / half - 32768, -32768, 32767);
}

class PadHand {
 public:
  InputRecord next(const TickReport& last) {
    const uint32_t tick = last.tick;
    // Half way the pad's battery goes: nothing for a second, then it comes back under another name.
    const uint32_t since = tick % 2400;
    if (since == 1200) player_.handle(padGone(pad_));
    if (since == 1260) ++pad_;
    if (since < 1200 || since >= 1260) {
      const int wide = tick / 600 % 2 ? 1 : 3;  // small moves too, down into the dead zone
      player_.handle(padAxis(pad_, SDL_CONTROLLER_AXIS_LEFTX, swing(tick, 331) / wide));
      player_.handle(padAxis(pad_, SDL_CONTROLLER_AXIS_LEFTY, swing(tick + 83, 331) / wide));
      // Let go now and then: the ship then keeps its last aim and does not fire.
      const bool aims = tick % 240 < 200;
      player_.handle(padAxis(pad_, SDL_CONTROLLER_AXIS_RIGHTX, aims ? swing(tick, 97) : 0));
      player_.handle(padAxis(pad_, SDL_CONTROLLER_AXIS_RIGHTY, aims ? swing(tick + 24, 97) : 0));
      player_.handle(padAxis(pad_, SDL_CONTROLLER_AXIS_TRIGGERLEFT, tick % 700 > 680 ? 32767 : 0));
      player_.handle(padButton(pad_, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, tick % 1100 > 1095));
      player_.handle(padButton(pad_, SDL_CONTROLLER_BUTTON_DPAD_UP, tick % 500 > 470));
    }
    return player_.record({last.ship_x, last.ship_y}, {last.ship_x, last.ship_y + 1});
  }

 private:
  PlayerInput player_;
  SDL_JoystickID pad_ = 1;
};

}  // namespace

void addPads(Scripts& scripts) {
  scripts["pad"] = [] {
    return [hand = std::make_shared<PadHand>()](const TickReport& last) { return hand->next(last); };
  };
}

}  // namespace gw
