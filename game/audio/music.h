// How the music follows the game: quieter behind screens, and stuttering as the frame budget runs out. Pure.
#pragma once

#include <cstdint>

#include "game/sim/simulation.h"

namespace gw {

// What the player is looking at.
enum class Scene : uint32_t { title, play, pause, over };

float musicLevel(Scene scene);
float effectsLevel(Scene scene);  // the title's own game is seen, hardly heard

struct Stutter {
  float gain = 1, pitch = 1;
};

// The music as a machine of that frame time would play it: it drops out for a few ticks, more often and deeper
// the nearer the budget is to its limit, and runs a little slow. Untouched during the first quarter of the way.
Stutter stutter(uint32_t tick, uint32_t frameTime_us, const Rules& rules);

}  // namespace gw
