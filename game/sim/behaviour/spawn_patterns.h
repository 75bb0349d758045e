// Where the k-th birth of a command appears: pure functions of the command, the seed and k.
#pragma once

#include "game/sim/state.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"

namespace gw::GW_DEVICE {

inline constexpr float kWallMargin_m = 1.5f;  // births keep this far from the walls

inline constexpr uint32_t kRainTries = 16;  // a position clear of the ship is found with odds of 1 - 1e-13 in play

// Folds a coordinate that lies past a wall back inside.
GW_FN float folded(float value, float size) {
  const float low = kWallMargin_m, high = size - kWallMargin_m;
  if (value < low) value = low + (low - value);
  if (value > high) value = high - (value - high);
  return clamp(value, low, high);
}

// Moves a position that is nearer to the ship than the clearance: first through the middle of the world (a
// position that was folded at a wall lands far away), then straight away from the ship.
GW_FN Float2 cleared(Float2 position, float ship_x, float ship_y, const Limits& limits, float clearance_m) {
  if (length(position.x - ship_x, position.y - ship_y) >= clearance_m) return position;
  position = {limits.width_m - position.x, limits.height_m - position.y};
  if (length(position.x - ship_x, position.y - ship_y) >= clearance_m) return position;
  // The ship is near the middle of the world: towards the farther walls there is room.
  const float away_x = 2.0f * ship_x > limits.width_m ? -clearance_m : clearance_m;
  const float away_y = 2.0f * ship_y > limits.height_m ? -clearance_m : clearance_m;
  return {folded(ship_x + away_x, limits.width_m), folded(ship_y + away_y, limits.height_m)};
}

// The unbounded shapes, around the ship at (c.x, c.y). u and w are uniform in [0, 1).
GW_FN Float2 patternPosition(const Command& c, uint32_t k, float u, float w, const Limits& limits) {
  const float share = (float(k) + 0.5f) / float(c.count);
  const SineCosine along = sineCosine(c.angle_rad);
  switch (c.pattern) {
    case Pattern::ring: {
      const SineCosine at = sineCosine(c.angle_rad + share * kTwoPi);
      const float radius = 20.0f + 6.0f * u;
      return {c.x + at.cosine * radius, c.y + at.sine * radius};
    }
    case Pattern::spiral: {
      const SineCosine at = sineCosine(c.angle_rad + share * 3.0f * kTwoPi);
      const float radius = 16.0f + 16.0f * share;
      return {c.x + at.cosine * radius, c.y + at.sine * radius};
    }
    case Pattern::cluster: {
      // The middle is the same for all of a command: its distance comes from the angle's own bits.
      const float distance = 24.0f + 16.0f * (along.sine * along.sine);
      const float size = 0.75f * sqrtf(float(c.count)), radius = size * sqrtf(u);
      const SineCosine at = sineCosine(w * kTwoPi);
      return {c.x + along.cosine * distance + at.cosine * radius, c.y + along.sine * distance + at.sine * radius};
    }
    case Pattern::corners: {
      const float side_x = k & 1u ? 30.0f : -30.0f, side_y = k & 2u ? 18.0f : -18.0f;
      const float spread = 2.0f + 0.5f * sqrtf(float(c.count));
      return {c.x + side_x + (2.0f * u - 1.0f) * spread, c.y + side_y + (2.0f * w - 1.0f) * spread};
    }
    case Pattern::wall: {
      // 64 m across, with a gap of 12 % somewhere in its middle half.
      const float gap = 0.25f + 0.38f * (along.cosine * along.cosine);
      float t = share * 0.88f;
      if (t > gap) t += 0.12f;
      const float offset = (t - 0.5f) * 64.0f, distance = 24.0f + 10.0f * u;
      return {c.x + along.cosine * distance - along.sine * offset, c.y + along.sine * distance + along.cosine * offset};
    }
    case Pattern::rain:
      return {u * limits.width_m, w * limits.height_m};
    default: {  // river: a band 24 m wide across the whole world, beside the ship
      const float offset = (along.sine < 0.0f ? -28.0f : 28.0f) + (w - 0.5f) * 24.0f;
      if (along.cosine * along.cosine < 0.5f) return {c.x + offset, u * limits.height_m};
      return {u * limits.width_m, c.y + offset};
    }
  }
}

// Inside the world, clear of the ship.
GW_FN Float2 birthPosition(const Command& c, uint32_t k, uint64_t seed, uint32_t tick, uint32_t command,
                           const Tables& tables) {
  const float clearance_m =
      tables.mode == Mode::swarm ? tables.rules.swarm.clearance_m : tables.rules.world.spawnClearance_m;
  Float2 inside{};
  // Rain that would fall too near falls elsewhere; the other patterns keep their shape.
  const uint32_t tries = c.pattern == Pattern::rain ? kRainTries : 1;
  for (uint32_t attempt = 0; attempt < tries; ++attempt) {
    const Uint4 dice = philox(seed, {tick, command | attempt << 16, kPurposePlace, k});
    const Float2 wished = patternPosition(c, k, unitFloat(dice.x), unitFloat(dice.y), tables.limits);
    inside = {folded(wished.x, tables.limits.width_m), folded(wished.y, tables.limits.height_m)};
    if (length(inside.x - c.x, inside.y - c.y) >= clearance_m) return inside;
  }
  return cleared(inside, c.x, c.y, tables.limits, clearance_m);
}

}  // namespace gw::GW_DEVICE
