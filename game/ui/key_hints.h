// What the screens call the keys, as they are bound and as the keyboard's layout names them.
#pragma once

#include <string>

namespace gw {

struct Bindings;

struct KeyHints {
  std::string move = "WASD", aim = "ARROWS or MOUSE", flush = "SPACE";
  std::string pause = "ESC", confirm = "ENTER", retry = "R", quit = "Q", settings = "O", fullscreen = "F", mute = "M";
  std::string spawn = "N", clear = "C", more = "=", fewer = "-", slowMotion = "T";  // practice
  std::string confirmToo = "or click, or space";                                    // on the title; may be empty
  // While a replay is watched.
  std::string stepOn = ".", stepBack = ",", faster = "+", slower = "-", camera = "C", help = "H", ship = "0",
              pan = "WASD";
};

// The keys, or the pad's buttons; where a pad has none the keys. Asked again for every picture, so that another layout
// shows at once. Builds with a window only.
KeyHints keyHints(const Bindings& bindings, bool pad);

}  // namespace gw
