// play_with_pad [options of gpuwars play]
// The game itself, with a controller that SDL makes up and that follows stdin, a command a line:
//   attach | detach | axis NAME VALUE | button NAME 0|1        names and values as SDL has them
// Each is answered by "done" on stdout; the end of stdin leaves the controller as it is.
#include <SDL.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "game/command_line.h"
#include "game/commands/commands.h"

namespace {

SDL_Joystick* pad = nullptr;

bool attach() {
  const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                               SDL_CONTROLLER_BUTTON_MAX, 0);
  pad = device < 0 ? nullptr : SDL_JoystickOpen(device);
  return pad != nullptr;
}

bool detach() {
  const SDL_JoystickID id = SDL_JoystickInstanceID(pad);
  for (int device = 0; device < SDL_NumJoysticks(); ++device) {
    if (SDL_JoystickGetDeviceInstanceID(device) != id) continue;
    const bool gone = SDL_JoystickDetachVirtual(device) == 0;
    SDL_JoystickClose(pad);
    pad = nullptr;
    return gone;
  }
  return false;
}

bool obey(const std::string& line) {
  std::istringstream words(line);
  std::string what, name;
  int value = 0;
  words >> what >> name >> value;
  SDL_LockJoysticks();
  bool good = false;
  if (what == "attach") good = attach();
  if (what == "detach" && pad) good = detach();
  if (what == "axis" && pad) {
    good = SDL_JoystickSetVirtualAxis(pad, SDL_GameControllerGetAxisFromString(name.c_str()), Sint16(value)) == 0;
  }
  if (what == "button" && pad) {
    good = SDL_JoystickSetVirtualButton(pad, SDL_GameControllerGetButtonFromString(name.c_str()), Uint8(value)) == 0;
  }
  SDL_UnlockJoysticks();
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const gw::ParsedCommandLine parsed = gw::parseCommandLine({argv + 1, argv + argc});
  if (!parsed.run) {
    std::fprintf(stderr, "%s\n", parsed.error.c_str());
    return int(parsed.code);
  }
  // Without a window manager no window has the focus, and pads are heard only in a window that has it.
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
  if (SDL_InitSubSystem(SDL_INIT_JOYSTICK) != 0) {
    std::fprintf(stderr, "SDL has no joysticks: %s\n", SDL_GetError());
    return 1;
  }
  std::thread([] {
    for (std::string line; std::getline(std::cin, line);) {
      std::printf("%s\n", obey(line) ? "done" : SDL_GetError());
      std::fflush(stdout);
    }
  }).detach();
  try {
    const auto code = int(gw::playWindow(parsed.options));
    std::fflush(stdout);
    std::_Exit(code);  // the thread may wait for stdin for ever
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::_Exit(1);
  }
}
