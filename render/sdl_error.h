// What SDL says of its last failure.
#pragma once

#include <SDL_error.h>

#include <string>

namespace gw {

// " (the reason)", to be put behind what failed. Empty when SDL gives no reason, which depends on its version.
inline std::string sdlReason() {
  const char* reason = SDL_GetError();
  return reason && *reason != '\0' ? std::string(" (") + reason + ")" : std::string();
}

}  // namespace gw
