// SDL's events, made by hand.
#pragma once

#include <SDL_events.h>

namespace gw {

inline SDL_Event padAxis(SDL_JoystickID pad, uint8_t axis, int value) {
  SDL_Event event{};
  event.type = SDL_CONTROLLERAXISMOTION;
  event.caxis.which = pad;
  event.caxis.axis = axis;
  event.caxis.value = Sint16(value);
  return event;
}

inline SDL_Event padButton(SDL_JoystickID pad, uint8_t button, bool down) {
  SDL_Event event{};
  event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
  event.cbutton.which = pad;
  event.cbutton.button = button;
  return event;
}

inline SDL_Event padGone(SDL_JoystickID pad) {
  SDL_Event event{};
  event.type = SDL_CONTROLLERDEVICEREMOVED;
  event.cdevice.which = pad;
  return event;
}

inline SDL_Event key(SDL_Scancode code, bool down) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.scancode = code;
  return event;
}

inline SDL_Event mouseTo(int x_px, int y_px) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = x_px;
  event.motion.y = y_px;
  return event;
}

inline SDL_Event mouseButton(uint8_t button, bool down, int x_px, int y_px) {
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = button;
  event.button.x = x_px;
  event.button.y = y_px;
  return event;
}

inline SDL_Event mouseWheel(int steps) {
  SDL_Event event{};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.y = steps;
  return event;
}

}  // namespace gw
