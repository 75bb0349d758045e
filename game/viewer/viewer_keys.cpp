#include "game/viewer/viewer_keys.h"

#include <utility>

namespace gw {

namespace {

// Places on the board, so that they are a cross on every layout.
int crossIndex(SDL_Scancode code) {
  switch (code) {
    case SDL_SCANCODE_W:
      return 0;
    case SDL_SCANCODE_A:
      return 1;
    case SDL_SCANCODE_S:
      return 2;
    case SDL_SCANCODE_D:
      return 3;
    default:
      return -1;
  }
}

}  // namespace

// By what is printed on the key: plus and comma lie elsewhere on other layouts. Held keys repeat.
bool ViewerKeys::press(const SDL_Keysym& key) {
  const bool shift = (key.mod & KMOD_SHIFT) != 0;
  switch (key.sym) {
    case SDLK_SPACE:
      ++presses_.pauses;
      return true;
    case SDLK_h:
      ++presses_.helps;
      return true;
    case SDLK_PERIOD:
      ++presses_.ticks;
      return true;
    case SDLK_COMMA:
      --presses_.ticks;
      return true;
    case SDLK_PLUS:
    case SDLK_EQUALS:
    case SDLK_KP_PLUS:
      ++presses_.speeds;
      return true;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
      --presses_.speeds;
      return true;
    case SDLK_LEFT:
      presses_.seconds -= shift ? 60 : 5;
      return true;
    case SDLK_RIGHT:
      presses_.seconds += shift ? 60 : 5;
      return true;
    case SDLK_PAGEUP:
      presses_.seconds -= 60;
      return true;
    case SDLK_PAGEDOWN:
      presses_.seconds += 60;
      return true;
    case SDLK_HOME:
      presses_.home = true;
      return true;
    case SDLK_END:
      presses_.end = true;
      return true;
    case SDLK_c:
      presses_.freeCamera = true;
      return true;
    case SDLK_0:
    case SDLK_KP_0:
      presses_.followShip = true;
      return true;
    default:
      return false;
  }
}

bool ViewerKeys::handle(const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN: {
      const SDL_Keysym& key = event.key.keysym;
      const int cross = crossIndex(key.scancode);
      if (cross >= 0) return held_[cross] = true;
      const bool once = key.sym == SDLK_SPACE || key.sym == SDLK_h || key.sym == SDLK_c;  // toggles do not flutter
      return (event.key.repeat != 0 && once) || press(key);
    }
    case SDL_KEYUP:
      if (const int cross = crossIndex(event.key.keysym.scancode); cross >= 0) held_[cross] = false;
      return false;  // a release harms nobody
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      if (event.button.button != SDL_BUTTON_LEFT) return true;
      button_ = event.type == SDL_MOUSEBUTTONDOWN;
      presses_.clicked |= button_;
      x_ = float(event.button.x);
      y_ = float(event.button.y);
      if (button_) presses_.click_x = x_, presses_.click_y = y_;  // it may move on within the frame
      seen_ = true;
      return true;
    case SDL_MOUSEMOTION:
      if (button_) {
        presses_.drag_x += float(event.motion.x) - x_;
        presses_.drag_y += float(event.motion.y) - y_;
      }
      x_ = float(event.motion.x);
      y_ = float(event.motion.y);
      seen_ = true;
      return true;
    case SDL_MOUSEWHEEL:
      presses_.wheel += event.wheel.y;
      return true;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {  // keys let go elsewhere send no event here
        for (bool& held : held_) held = false;
        button_ = false;
      }
      return false;
    default:
      return false;
  }
}

ViewerPresses ViewerKeys::take() {
  return std::exchange(presses_, {});
}

}  // namespace gw
