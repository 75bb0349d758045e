#include "game/input/pad_devices.h"

#include <SDL.h>

#include <algorithm>

namespace gw {

PadDevices::PadDevices() {
  started_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
  if (!started_) {
    problem_ = std::string("Game controllers cannot be used (") + SDL_GetError() +
               "): play with keyboard and mouse, or check who may read /dev/input.";
  }
}

PadDevices::~PadDevices() {
  pads_.clear();
  if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void PadDevices::handle(const SDL_Event& event) {
  const auto idOf = [](const std::unique_ptr<SDL_GameController, Close>& pad) {
    return SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad.get()));
  };
  if (event.type == SDL_CONTROLLERDEVICEADDED) {
    // A device may be gone again, or announced twice.
    std::unique_ptr<SDL_GameController, Close> pad(SDL_GameControllerOpen(event.cdevice.which));
    if (!pad) return;
    const SDL_JoystickID id = idOf(pad);
    const bool known = std::any_of(pads_.begin(), pads_.end(), [&](const auto& other) { return idOf(other) == id; });
    if (!known) pads_.push_back(std::move(pad));
  }
  if (event.type == SDL_CONTROLLERDEVICEREMOVED) {
    std::erase_if(pads_, [&](const auto& pad) { return idOf(pad) == event.cdevice.which; });
  }
}

}  // namespace gw
