// The events of a frame, as the game is to see them.
#pragma once

#include <SDL_events.h>

#include <vector>

namespace gw {

// What has come since the last call, in place of what `events` holds.
void takeEvents(std::vector<SDL_Event>& events);

// A pad that is pulled out may first send what no hand did: sdl2-compat lets its axes jump to the first values they
// ever had. So of a pad that goes within these events only its going is left.
void dropLastEventsOfLeavingPads(std::vector<SDL_Event>& events);

}  // namespace gw
