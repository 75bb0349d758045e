#include "host/input/frame_events.h"

#include <algorithm>
#include <optional>

namespace gw {

namespace {

std::optional<SDL_JoystickID> padMovedBy(const SDL_Event& event) {
  switch (event.type) {
    case SDL_CONTROLLERAXISMOTION:
      return event.caxis.which;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      return event.cbutton.which;
    default:
      return std::nullopt;
  }
}

}  // namespace

void takeEvents(std::vector<SDL_Event>& events) {
  events.clear();
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) events.push_back(event);
  dropLastEventsOfLeavingPads(events);
}

void dropLastEventsOfLeavingPads(std::vector<SDL_Event>& events) {
  std::vector<SDL_JoystickID> leaving;
  for (const SDL_Event& event : events) {
    if (event.type == SDL_CONTROLLERDEVICEREMOVED) leaving.push_back(event.cdevice.which);
  }
  if (leaving.empty()) return;
  std::erase_if(events, [&](const SDL_Event& event) {
    const auto pad = padMovedBy(event);
    return pad && std::find(leaving.begin(), leaving.end(), *pad) != leaving.end();
  });
}

}  // namespace gw
