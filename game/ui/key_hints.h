// What the screens call the keys, as they are bound.
#pragma once

#include <string>

namespace gw {

struct Bindings;

struct KeyHints {
  std::string move = "WASD", aim = "ARROWS or MOUSE", flush = "SPACE";
  std::string pause = "ESC", confirm = "ENTER", retry = "R", quit = "Q", settings = "O", fullscreen = "F";
  std::string spawn = "N", clear = "C", more = "=", fewer = "-", slowMotion = "T";  // practice
  std::string confirmToo = "or click, or space";                                    // on the title; may be empty
};

// The keys, or the pad's buttons; where a pad has none the keys. Builds with a window only.
KeyHints keyHints(const Bindings& bindings, bool pad);

}  // namespace gw
