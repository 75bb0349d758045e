// Draws all entities: ship, shots, bits, enemies. Each is a signed-distance shape that includes its glow: a separate
// glow pass alone cost 26 ms a frame on llvmpipe.
#pragma once

#include <filesystem>

#include "render/instanced_pass.h"

namespace gw {

// How far light reaches outside a shape, 0 to 1. Its cost is the pixels it covers.
inline constexpr float kGlowOff = 0, kGlowLow = 0.5f, kGlowHigh = 1;

struct SpriteFrame {
  Camera camera;
  PixelSize target;           // of the picture, for lines of whole pixels
  float alpha = 1;            // 0: positions of the previous tick, 1: of the current one
  float tick = 0;             // ticks so far, for the blinking of the invulnerable ship
  float announced_ticks = 1;  // of the game's rules: the age at which the outline of an announced enemy has closed in
  float glow = kGlowLow;
  bool flashes = true;   // off: damage and blinking are steady light, for photosensitive players
  float brightness = 1;  // of all sprites; less behind menus
};

class SpritePass {
 public:
  explicit SpritePass(const std::filesystem::path& assets);

  // Draws the region in its own order: later sprites cover earlier ones. Call between written() and end().
  void draw(const StreamRegion& region, const SpriteFrame& frame);

 private:
  InstancedPass<SpriteVertex> pass_;
};

}  // namespace gw
