// play_with_pad [options of gpuwars play or gpuwars replay]
// The game itself, with controllers that SDL makes up and that follow stdin, a command a line:
//   attach | detach | axis NAME VALUE | button NAME 0|1        names and values as SDL has them
//   twin COMMAND                                               the same for a second controller
//   both MS COMMAND                                            for the first, and MS milliseconds later for the second
//   ask text_input | pointer_kept | fullscreen                 what SDL says, answered by 0 or 1
// Each is answered by "done" on stdout; the end of stdin leaves the controllers as they are.
#include <SDL.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "game/cli/command_line.h"

namespace {

SDL_Joystick* pads[2] = {};

bool attach(SDL_Joystick*& pad) {
  const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                               SDL_CONTROLLER_BUTTON_MAX, 0);
  pad = device < 0 ? nullptr : SDL_JoystickOpen(device);
  return pad != nullptr;
}

bool detach(SDL_Joystick*& pad) {
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

bool obey(SDL_Joystick*& pad, std::istringstream words) {
  std::string what, name;
  int value = 0;
  words >> what >> name >> value;
  SDL_LockJoysticks();
  bool good = false;
  if (what == "attach") good = attach(pad);
  if (what == "detach" && pad) good = detach(pad);
  if (what == "axis" && pad) {
    good = SDL_JoystickSetVirtualAxis(pad, SDL_GameControllerGetAxisFromString(name.c_str()), Sint16(value)) == 0;
  }
  if (what == "button" && pad) {
    good = SDL_JoystickSetVirtualButton(pad, SDL_GameControllerGetButtonFromString(name.c_str()), Uint8(value)) == 0;
  }
  SDL_UnlockJoysticks();
  return good;
}

// The only one. SDL 2 numbers windows from 1; where SDL 3 stands behind it, displays take numbers of the same row.
SDL_Window* firstWindow() {
  for (Uint32 id = 1; id < 100; ++id) {
    if (SDL_Window* window = SDL_GetWindowFromID(id)) return window;
  }
  throw std::runtime_error("there is no window to ask about");
}

std::string answer(const std::string& question) {
  const auto is = [&](Uint32 flag) { return (SDL_GetWindowFlags(firstWindow()) & flag) != 0; };
  if (question == "text_input") return SDL_IsTextInputActive() ? "1" : "0";
  if (question == "pointer_kept") return is(SDL_WINDOW_MOUSE_GRABBED) ? "1" : "0";
  return is(SDL_WINDOW_FULLSCREEN) ? "1" : "0";
}

std::string obey(const std::string& line) {
  std::istringstream words(line);
  std::string first;
  words >> first;
  const auto rest = [&] {
    std::string text;
    std::getline(words, text);
    return std::istringstream(text);
  };
  if (first == "ask") {
    words >> first;
    return answer(first);
  }
  bool good = false;
  if (first == "twin") {
    good = obey(pads[1], rest());
  } else if (first == "both") {
    int apart_ms = 0;
    words >> apart_ms;
    const std::string command = rest().str();
    good = obey(pads[0], std::istringstream(command));
    SDL_Delay(Uint32(apart_ms));
    good = obey(pads[1], std::istringstream(command)) && good;
  } else {
    good = obey(pads[0], std::istringstream(line));
  }
  return good ? "done" : std::string("not done: ") + SDL_GetError();
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
      std::printf("%s\n", obey(line).c_str());
      std::fflush(stdout);
    }
  }).detach();
  try {
    const auto code = int(std::visit([](const auto& options) { return gw::runVerb(options); }, parsed.options));
    std::fflush(stdout);
    std::_Exit(code);  // the thread may wait for stdin for ever
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::_Exit(1);
  }
}
