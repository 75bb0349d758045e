// Which key does what, as data. Keys are SDL scancodes: places on the board, so WASD stays a cross on
// every layout.
#pragma once

#include <SDL_scancode.h>

#include <array>
#include <cstdint>

namespace gw {

enum class Action : uint32_t {
  // Held.
  moveUp,
  moveDown,
  moveLeft,
  moveRight,
  // Held; aims and fires in 8 directions.
  aimUp,
  aimDown,
  aimLeft,
  aimRight,
  // Held.
  fire,
  flush,
  // Pressed.
  pause,
  confirm,
  retry,
  quit,
  fullscreen,
  mute,
  count
};
inline constexpr uint32_t kActions = uint32_t(Action::count);

struct KeyBinding {
  SDL_Scancode key;
  Action action;
};

struct ButtonBinding {
  uint8_t button;  // SDL_BUTTON_LEFT is 1, middle 2, right 3
  Action action;
};

struct Bindings {
  // Several keys may do one thing, and one key several: space flushes in play and starts on the title.
  std::array<KeyBinding, 21> keys{{
      {SDL_SCANCODE_W, Action::moveUp},       {SDL_SCANCODE_S, Action::moveDown},
      {SDL_SCANCODE_A, Action::moveLeft},     {SDL_SCANCODE_D, Action::moveRight},
      {SDL_SCANCODE_UP, Action::aimUp},       {SDL_SCANCODE_DOWN, Action::aimDown},
      {SDL_SCANCODE_LEFT, Action::aimLeft},   {SDL_SCANCODE_RIGHT, Action::aimRight},
      {SDL_SCANCODE_SPACE, Action::flush},    {SDL_SCANCODE_SPACE, Action::confirm},
      {SDL_SCANCODE_LSHIFT, Action::flush},   {SDL_SCANCODE_ESCAPE, Action::pause},
      {SDL_SCANCODE_P, Action::pause},        {SDL_SCANCODE_PAUSE, Action::pause},
      {SDL_SCANCODE_RETURN, Action::confirm}, {SDL_SCANCODE_KP_ENTER, Action::confirm},
      {SDL_SCANCODE_R, Action::retry},        {SDL_SCANCODE_Q, Action::quit},
      {SDL_SCANCODE_F11, Action::fullscreen}, {SDL_SCANCODE_F, Action::fullscreen},
      {SDL_SCANCODE_M, Action::mute},
  }};
  std::array<ButtonBinding, 3> buttons{{
      {1, Action::fire},
      {1, Action::confirm},
      {3, Action::flush},
  }};
};

}  // namespace gw
