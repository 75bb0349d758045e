// What the player chose, beyond the command line. Lives in one TOML file (settings_file.h); every value has
// a default, so that a missing or damaged entry costs that entry only.
#pragma once

#include "host/input/bindings.h"

namespace gw {

struct Settings {
  struct Sound {
    float effects = 0.8f, music = 0.6f;  // 0 to 1
    bool muted = false;
    friend bool operator==(const Sound&, const Sound&) = default;
  } sound;

  // Everything here is drawing only; off means not at all.
  struct Effects {
    float shake = 1;    // 0 to 1: every source of shake is scaled by it
    float flash = 1;    // 0 to 1: every sudden brightness of the whole picture is scaled by it
    float glow = 0.5f;  // 0 to 1: how far light reaches outside a shape; the dearest of all where no GPU draws
    bool particles = true;
    bool gridBending = true;
    bool scorePops = true;
    friend bool operator==(const Effects&, const Effects&) = default;
  } effects;

  struct Pad {
    float moveDeadZone = 0.2f, aimDeadZone = 0.25f;  // share of full deflection, 0 to 0.9
    friend bool operator==(const Pad&, const Pad&) = default;
  } pad;

  bool fullscreen = false;
  bool keepPointer = true;  // in the window, in play
  Bindings bindings;

  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace gw
