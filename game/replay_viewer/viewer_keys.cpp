#include "game/replay_viewer/viewer_keys.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "host/input/bindings.h"

namespace gw {

static_assert(kViewerStepOn == SDL_SCANCODE_PERIOD && kViewerStepBack == SDL_SCANCODE_COMMA);
static_assert(kViewerFaster == SDL_SCANCODE_EQUALS && kViewerSlower == SDL_SCANCODE_MINUS);
static_assert(kViewerCamera == SDL_SCANCODE_C && kViewerHelp == SDL_SCANCODE_H && kViewerShip == SDL_SCANCODE_0);
static_assert(kViewerPan[0] == SDL_SCANCODE_W && kViewerPan[1] == SDL_SCANCODE_A);
static_assert(kViewerPan[2] == SDL_SCANCODE_S && kViewerPan[3] == SDL_SCANCODE_D);

namespace {

int crossIndex(SDL_Scancode code) {
  const auto* found = std::find(std::begin(kViewerPan), std::end(kViewerPan), uint16_t(code));
  return found == std::end(kViewerPan) ? -1 : int(found - std::begin(kViewerPan));
}

// +1 and -1 for the keys of the speed. A layout that has plus and minus elsewhere has them there too, and what is
// printed on a key beats its place.
int speedSteps(const SDL_Keysym& key) {
  if (key.sym == SDLK_PLUS) return 1;
  if (key.sym == SDLK_MINUS) return -1;
  if (key.scancode == kViewerFaster || key.scancode == SDL_SCANCODE_KP_PLUS) return 1;
  return key.scancode == kViewerSlower || key.scancode == SDL_SCANCODE_KP_MINUS ? -1 : 0;
}

}  // namespace

// Held keys repeat.
bool ViewerKeys::press(const SDL_Keysym& key) {
  const int far_s = (key.mod & KMOD_SHIFT) != 0 ? 60 : 5;
  switch (key.scancode) {
    case SDL_SCANCODE_SPACE:
      ++presses_.pauses;
      return true;
    case kViewerHelp:
      ++presses_.helps;
      return true;
    case kViewerStepOn:
      ++presses_.ticks;
      return true;
    case kViewerStepBack:
      --presses_.ticks;
      return true;
    case SDL_SCANCODE_LEFT:
      presses_.seconds -= far_s;
      return true;
    case SDL_SCANCODE_RIGHT:
      presses_.seconds += far_s;
      return true;
    case SDL_SCANCODE_PAGEUP:
      presses_.seconds -= 60;
      return true;
    case SDL_SCANCODE_PAGEDOWN:
      presses_.seconds += 60;
      return true;
    case SDL_SCANCODE_HOME:
      presses_.home = true;
      return true;
    case SDL_SCANCODE_END:
      presses_.end = true;
      return true;
    case kViewerCamera:
      presses_.freeCamera = true;
      return true;
    case kViewerShip:
    case SDL_SCANCODE_KP_0:
      presses_.followShip = true;
      return true;
    default:
      presses_.speeds += speedSteps(key);
      return speedSteps(key) != 0;
  }
}

bool ViewerKeys::handle(const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN: {
      const SDL_Keysym& key = event.key.keysym;
      const int cross = crossIndex(key.scancode);
      if (cross >= 0) return held_[cross] = true;
      const bool once = key.scancode == SDL_SCANCODE_SPACE || key.scancode == kViewerHelp ||
                        key.scancode == kViewerCamera;  // toggles do not flutter
      return (event.key.repeat != 0 && once) || press(key);
    }
    case SDL_KEYUP:
      if (const int cross = crossIndex(event.key.keysym.scancode); cross >= 0) held_[cross] = false;
      return false;  // a release does no harm
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
