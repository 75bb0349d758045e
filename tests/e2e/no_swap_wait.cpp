// Preloaded into the game: a driver that promises to wait for the screen and does not, and how often a picture was
// shown, as a number in the file that GW_SWAPS names.
#include <SDL_video.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

extern "C" int SDL_GL_SetSwapInterval(int) {
  return 0;
}

extern "C" void SDL_GL_SwapWindow(SDL_Window* window) {
  static const auto real = reinterpret_cast<void (*)(SDL_Window*)>(dlsym(RTLD_NEXT, "SDL_GL_SwapWindow"));
  static std::FILE* file = std::fopen(std::getenv("GW_SWAPS"), "w");
  static unsigned long swaps = 0;
  real(window);
  std::rewind(file);
  std::fprintf(file, "%lu\n", ++swaps);
  std::fflush(file);
}
