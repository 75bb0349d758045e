#!/usr/bin/env bash
# SDL 2.26 on X11: switching between two layouts by the keyboard group ("us,fr" and a toggle key) leaves
# SDL_GetKeyFromScancode() at the first layout; only setting another layout changes it.
#
# One would guess that the key code of a place follows what the key types, since SDL listens to the server's keyboard
# events. With setxkbmap fr it does. With two layouts at once, as desktops set them up, the group changes and SDL's
# table does not: a game that labels its keys by layout goes on showing the other one.
#
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
readonly version=2.26.5+dfsg-1
for tool in Xvfb setxkbmap g++ pkg-config; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed." >&2; exit 2; }
done
[[ "$(dpkg-query -W -f '${Version}' libsdl2-dev 2>/dev/null)" == "$version" ]] || {
  echo "libsdl2-dev $version is not installed." >&2
  exit 2
}
folder="$(mktemp -d)"
trap 'kill "${server:-}" 2>/dev/null; rm -rf "$folder"' EXIT
cd "$folder" || exit 2

cat >keys.cpp <<'CPP'
#include <SDL.h>
#include <SDL_syswm.h>
#include <X11/XKBlib.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
static void wait() {
  for (int i = 0; i < 20; ++i) {
    SDL_PumpEvents();
    SDL_Delay(25);
  }
}
static void show(Display* display, const char* when) {
  XkbStateRec state;
  XkbGetState(display, XkbUseCoreKbd, &state);
  const KeyCode code = 24;  // the place of Q on a US keyboard
  const KeySym typed = XkbKeycodeToKeysym(display, code, state.group, 0);
  std::printf("%s: the key types %s, SDL says %s\n", when, XKeysymToString(typed),
              SDL_GetKeyName(SDL_GetKeyFromScancode(SDL_SCANCODE_Q)));
}
int main(int, char**) {
  if (std::system("setxkbmap us,fr") != 0) return 2;
  if (SDL_Init(SDL_INIT_VIDEO) != 0 || std::strcmp(SDL_GetCurrentVideoDriver(), "x11") != 0) return 2;
  SDL_Window* window = SDL_CreateWindow("keys", 0, 0, 200, 200, SDL_WINDOW_SHOWN);
  Display* display = XOpenDisplay(nullptr);
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (!window || !display || !SDL_GetWindowWMInfo(window, &info)) return 2;
  wait();
  XSetInputFocus(display, info.info.x11.window, RevertToParent, CurrentTime);
  XSync(display, False);
  wait();
  if (SDL_GetKeyboardFocus() != window) return 2;
  show(display, "us,fr, first group");
  XkbLockGroup(display, XkbUseCoreKbd, 1);
  XSync(display, False);
  wait();
  show(display, "us,fr, second group");
  XkbLockGroup(display, XkbUseCoreKbd, 0);
  XSync(display, False);
  if (std::system("setxkbmap fr") != 0) return 2;
  wait();
  XCloseDisplay(display);
  display = XOpenDisplay(nullptr);
  show(display, "fr");
}
CPP
g++ keys.cpp $(pkg-config --cflags --libs sdl2 x11) -o keys || exit 2
Xvfb -displayfd 7 -screen 0 640x480x24 -noreset 7>display 2>/dev/null &
server=$!
for _ in $(seq 50); do [[ -s display ]] && break; sleep 0.1; done
[[ -s display ]] || exit 2
seen="$(DISPLAY=":$(cat display)" SDL_VIDEODRIVER=x11 ./keys)" || exit 2
expected='us,fr, first group: the key types q, SDL says Q
us,fr, second group: the key types a, SDL says Q
fr: the key types a, SDL says A'
echo "SDL $version:"
echo "$seen"
[[ "$seen" == "$expected" ]]
