// One particle at its birth. Nothing is updated while it lives: its position follows from its age.
#pragma once

#include <cstdint>

namespace gw {

struct Particle {
  float x = 0, y = 0;                    // m, at birth
  float velocity_x = 0, velocity_y = 0;  // m/s, at birth; drag slows it down
  uint32_t birthTick = 0, life_ticks = 0;
  uint32_t colour = 0;  // 0xRRGGBB
  float size_m = 0;     // half width of the streak
};
static_assert(sizeof(Particle) == 32);

// Velocity falls by this exponent per second: a spark of 18 m/s travels 3.6 m.
inline constexpr float kParticleDrag_per_s = 5;
// A streak reaches back to where its head was this long ago.
inline constexpr float kParticleStreak_s = 0.1f;

}  // namespace gw
