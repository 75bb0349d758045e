// What the draw kernels write and the passes read, one instance each: sprites and particles.
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

// One particle: a streak whose light falls off towards its tail.
struct ParticleVertex {
  float x, y;            // head, metres
  float tail_x, tail_y;  // where the head was a moment ago
  float size_m;          // half width at the head
  float light;           // 1 full .. 0 gone
  uint32_t colour;       // 0xRRGGBB
};
static_assert(sizeof(ParticleVertex) == 28);

// The indirect draw record behind glDrawArraysIndirect; the kernel writes instanceCount.
struct DrawArraysCommand {
  uint32_t vertexCount, instanceCount, firstVertex, baseInstance;
};
static_assert(sizeof(DrawArraysCommand) == 16);

}  // namespace gw
