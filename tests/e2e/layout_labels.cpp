// layout_labels: in a window of its own, what the screens call the keys under the keyboard layout of the moment: one
// line for each line of stdin, "name=label" between tabs, and first "sdl=" and its version.
#include <SDL.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "game/ui/key_hints.h"
#include "host/input/bindings.h"

int main() {
  if (SDL_Init(SDL_INIT_VIDEO) != 0) {
    std::fprintf(stderr, "SDL has no display: %s\n", SDL_GetError());
    return 1;
  }
  SDL_Window* window = SDL_CreateWindow("layout_labels", 0, 0, 64, 64, 0);
  for (std::string line; std::getline(std::cin, line);) {
    for (int i = 0; i < 20; ++i) {  // the server's news come when they come
      SDL_PumpEvents();
      SDL_Delay(10);
    }
    const gw::KeyHints keys = gw::keyHints(gw::Bindings(), false);
    const std::pair<const char*, std::string> labels[] = {{"move", keys.move},
                                                          {"flush", keys.flush},
                                                          {"pause", keys.pause},
                                                          {"confirm", keys.confirm},
                                                          {"retry", keys.retry},
                                                          {"quit", keys.quit},
                                                          {"settings", keys.settings},
                                                          {"fullscreen", keys.fullscreen},
                                                          {"mute", keys.mute},
                                                          {"more", keys.more},
                                                          {"fewer", keys.fewer},
                                                          {"step_on", keys.stepOn},
                                                          {"faster", keys.faster},
                                                          {"step_back", keys.stepBack},
                                                          {"slower", keys.slower},
                                                          {"camera", keys.camera},
                                                          {"help", keys.help},
                                                          {"ship", keys.ship},
                                                          {"pan", keys.pan}};
    SDL_version sdl;
    SDL_GetVersion(&sdl);
    std::printf("sdl=%d.%d.%d\t", sdl.major, sdl.minor, sdl.patch);
    for (const auto& [name, label] : labels) std::printf("%s=%s\t", name, label.c_str());
    std::printf("\n");
    std::fflush(stdout);
  }
  SDL_DestroyWindow(window);
  SDL_Quit();
  return 0;
}
