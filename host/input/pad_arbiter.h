// Whose presses count when several game controllers send some.
//
// One pad may be listed twice, as itself and as what a launcher or a second driver makes of it; then each of its
// presses comes twice, some milliseconds apart. So the pad that pressed last has its turn, and presses of others count
// only after it has been quiet for a moment.
#pragma once

#include <SDL_joystick.h>

#include <cstdint>
#include <optional>

namespace gw {

class PadArbiter {
 public:
  // Longer than two drivers lie apart, shorter than a hand needs from one pad to another.
  static constexpr int32_t kQuiet_ms = 50;

  // At this time of SDL's clock the pads were looked at. Between two looks nothing is known of when a press came, and
  // on a slow machine they lie farther apart than twins do: so a press counts as old as the look before it.
  void looked(uint32_t now_ms) { looked_ms_ = now_ms; }

  // Whether a press by `pad` counts, at the time of its event.
  bool mayPress(SDL_JoystickID pad, uint32_t now_ms) const {
    return !turn_ || *turn_ == pad || int32_t(looked_ms_.value_or(now_ms) - pressed_ms_) >= kQuiet_ms;
  }

  // It presses: when that counts, the turn is this pad's.
  bool press(SDL_JoystickID pad, uint32_t now_ms) {
    if (!mayPress(pad, now_ms)) return false;
    turn_ = pad;
    pressed_ms_ = now_ms;
    return true;
  }

  // The pad went away: it is not waited for.
  void forget(SDL_JoystickID pad) {
    if (turn_ == pad) turn_.reset();
  }

 private:
  std::optional<SDL_JoystickID> turn_;
  uint32_t pressed_ms_ = 0;
  std::optional<uint32_t> looked_ms_;
};

}  // namespace gw
