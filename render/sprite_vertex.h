// One sprite as the draw-list kernel writes it and the sprite pass reads it (one instance each).
#pragma once

#include <cstdint>

namespace gw {

enum SpriteFlag : uint32_t {
  kSpriteAnnounced = 1u << 0,    // not yet harmful: drawn as an outline that closes in
  kSpriteDamaged = 1u << 1,      // was hit this tick or the last: flashes
  kSpriteUntouchable = 1u << 2,  // the ship after contact: blinks
};

struct SpriteVertex {
  float x, y;                    // place at the end of the tick, metres
  float previous_x, previous_y;  // place one tick earlier; the vertex shader interpolates
  float angle_rad;               // heading, counter-clockwise from +x
  float size_m;                  // half extent of the drawn shape
  uint32_t shapeFlags;  // Shape in bits 0..7, SpriteFlag bits from 8, energy share 0..255 from bit 16, age in ticks
                        // (saturated at 255) from 24
  uint32_t colour;      // 0xRRGGBB
};
static_assert(sizeof(SpriteVertex) == 32);

// The indirect draw record behind glDrawArraysIndirect; the kernel writes instanceCount.
struct DrawArraysCommand {
  uint32_t vertexCount, instanceCount, firstVertex, baseInstance;
};
static_assert(sizeof(DrawArraysCommand) == 16);

}  // namespace gw
