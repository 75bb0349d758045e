// Keyboard and mouse events through the game's own input code; in practice its keys too.
#include <memory>

#include "game/input/player_input.h"
#include "game/session/practice.h"
#include "tests/replays/events.h"
#include "tests/replays/script.h"

namespace gw {

namespace {

constexpr int kCentre_x_px = 640, kCentre_y_px = 360;
constexpr float kScale_m = 1.0f / 18.0f;  // per pixel, as where 40 m are 720 px high

class KeyHand {
 public:
  InputRecord next(const TickReport& last) {
    const uint32_t tick = last.tick;
    // Periods without a common divisor: all combinations come, opposite keys included.
    hold(SDL_SCANCODE_D, tick % 94 < 50);
    hold(SDL_SCANCODE_A, tick % 107 > 60);
    hold(SDL_SCANCODE_W, tick % 83 < 40);
    hold(SDL_SCANCODE_S, tick % 71 > 38);
    // The arrows aim for two seconds of every seven, then the mouse takes the aim back.
    const bool arrows = tick % 420 >= 300;
    hold(SDL_SCANCODE_UP, arrows && tick % 60 < 35);
    hold(SDL_SCANCODE_RIGHT, arrows && tick % 60 > 20);
    if (!arrows) {
      x_px_ = kCentre_x_px + int(tick * 37 % 1201) - 600;
      y_px_ = kCentre_y_px + int(tick * 23 % 641) - 320;
      player_.handle(mouseTo(x_px_, y_px_));
    }
    hold(SDL_BUTTON_LEFT, tick % 45 < 40, true);
    hold(SDL_BUTTON_RIGHT, tick % 901 > 897, true);
    practise(tick);
    const WorldPoint under = {last.ship_x + float(x_px_ - kCentre_x_px) * kScale_m,
                              last.ship_y - float(y_px_ - kCentre_y_px) * kScale_m};
    InputRecord record = player_.record({last.ship_x, last.ship_y}, under);
    record.buttons |= practice_.takeButtons();
    return record;
  }

 private:
  void hold(int code, bool down, bool mouse = false) {
    player_.handle(mouse ? mouseButton(uint8_t(code), down, x_px_, y_px_) : key(SDL_Scancode(code), down));
  }

  // A type by its number, more or fewer by the wheel, and N pressed twice within the time of one tick.
  void practise(uint32_t tick) {
    if (tick % 200 == 90) {
      const auto number = SDL_Scancode(SDL_SCANCODE_1 + tick / 200 % 7);
      player_.handle(key(number, true));
      player_.handle(key(number, false));
      player_.handle(mouseWheel(tick / 200 % 3 == 0 ? 1 : tick / 200 % 3 == 1 ? -1 : 0));
      for (const bool down : {true, false, true, false}) player_.handle(key(SDL_SCANCODE_N, down));
    }
    hold(SDL_SCANCODE_C, tick % 2000 == 1999);
    PracticePresses presses;
    presses.number = player_.number();
    presses.more = player_.wheel();
    while (player_.pressed(Action::spawn)) ++presses.spawn;
    while (player_.pressed(Action::clear)) ++presses.clear;
    practice_.press(presses);
  }

  PlayerInput player_;
  Practice practice_{7};
  int x_px_ = kCentre_x_px, y_px_ = kCentre_y_px;
};

}  // namespace

void addKeys(Scripts& scripts) {
  scripts["keys"] = [] {
    return [hand = std::make_shared<KeyHand>()](const TickReport& last) { return hand->next(last); };
  };
}

}  // namespace gw
