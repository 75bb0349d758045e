// Draws everything that lives: ship, shots, bits, enemies, each a signed-distance shape whose glow is part
// of the shape itself (no post pass: that alone cost 26 ms a frame on llvmpipe).
#pragma once

#include <filesystem>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/vertex_stream.h"

namespace gw {

// How far light reaches outside a shape: 0 not at all, 1 the furthest. The price is the pixels it covers.
inline constexpr float kGlowOff = 0, kGlowLow = 0.5f, kGlowHigh = 1;

struct SpriteFrame {
  Camera camera;
  PixelSize target;           // of the picture, for lines of whole pixels
  float alpha = 1;            // 0: the previous tick's places, 1: the current ones
  float tick = 0;             // ticks so far, for the blink of the untouchable ship
  float announced_ticks = 1;  // of the game's rules: the age at which the outline of an announced enemy has closed in
  float glow = kGlowLow;
  bool flashes = true;   // off: damage and blinking are shown by steady light, for photosensitive players
  float brightness = 1;  // of all sprites; less behind menus
};

class SpritePass {
 public:
  explicit SpritePass(const std::filesystem::path& assets);

  // Draws the region in its own order: later sprites cover earlier ones. Call between written() and end().
  void draw(const StreamRegion& region, const SpriteFrame& frame);

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace gw
