#include "host/input/pad_devices.h"

#include <SDL.h>

#include <algorithm>

#include "render/sdl_error.h"

namespace gw {

PadDevices::PadDevices() {
  started_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
  if (!started_) {
    problem_ = "Game controllers cannot be used" + sdlReason() +
               ": play with keyboard and mouse, or check who may read /dev/input.";
    return;
  }
  for (int device = 0; device < SDL_NumJoysticks(); ++device) open(device);
}

PadDevices::~PadDevices() {
  pads_.clear();
  if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

// The device may be no game controller, gone again, or open already: what is connected at the start is announced too.
void PadDevices::open(int device) {
  if (!SDL_IsGameController(device)) return;
  Pad pad(SDL_GameControllerOpen(device));
  if (!pad) return;
  const SDL_JoystickID id = idOf(pad);
  const bool known = std::any_of(pads_.begin(), pads_.end(), [&](const Pad& other) { return idOf(other) == id; });
  if (!known) pads_.push_back(std::move(pad));
}

SDL_JoystickID PadDevices::idOf(const Pad& pad) {
  return SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad.get()));
}

void PadDevices::handle(const SDL_Event& event) {
  if (event.type == SDL_CONTROLLERDEVICEADDED) open(event.cdevice.which);
  if (event.type == SDL_CONTROLLERDEVICEREMOVED) {
    std::erase_if(pads_, [&](const Pad& pad) { return idOf(pad) == event.cdevice.which; });
  }
}

}  // namespace gw
