// The shapes of sprites, in one table: numbers for draw kernels and enemy tables, constants for the sprite shaders,
// icons for screens. Plain data.
//
// A shape is what remains of it after folding along its mirror lines: the inside of at most three sides. Folding is
// always along the heading (y), from Fold::across on also across it (x), and Fold::diagonal along the diagonal as well.
//
//   y |  /.|   a star, folded diagonally, is
//     | /.  *   one side: from its tip
//     +------x  to its notch
//
// A new shape is a row here: the last one of those that enemies may have, since replays hold the numbers.
#pragma once

#include <cstdint>

namespace gw {

struct ShapeCorner {
  float x, y;  // +x is the heading; the half extent of a shape is about 1
};

enum class Fold : uint32_t { along, across, diagonal };

struct SpriteShape {
  const char* name = nullptr;  // in assets/enemies.toml; none: no enemy has it
  Fold fold = Fold::along;
  uint32_t cornerCount = 0;     // none: a circle
  ShapeCorner corners[4] = {};  // of the folded outline, counter-clockwise: the inside is to the left
  float radius = 1;  // through the furthest corners: the shape ends there too, which bevels the light past sharp ones
  float lineWidth = 1;
  float fillFull = 0, fillSpent = 0;  // of the inside, with all energy and with none
  float cover = .75f;                 // how strongly the inside covers what lies below
  bool turns = true;  // with its heading; an upright rectangle is what collides, so that is what is shown
  bool chequered = false;
  float innerRing = 0;  // radius; 0: none
  float glowReach = 1;  // how much further than others' its glow reaches
};

// SHAPE(name, members of SpriteShape...). Those of enemies come first.
#define GW_SPRITE_SHAPES(SHAPE)                                                                                      \
  SHAPE(triangle, .name = "triangle", .cornerCount = 3, .corners = {{1, 0}, {-.62f, .92f}, {-.62f, 0}},              \
        .radius = 1.11f, .fillFull = .26f, .fillSpent = .04f)                                                        \
  SHAPE(square, .name = "square", .fold = Fold::diagonal, .cornerCount = 2, .corners = {{1, 0}, {1, 1}},             \
        .radius = 1.415f, .fillFull = .22f, .fillSpent = .04f, .turns = false)                                       \
  SHAPE(hexagon, .name = "hexagon", .fold = Fold::across, .cornerCount = 3,                                          \
        .corners = {{1, 0}, {.5f, .866f}, {0, .866f}}, .lineWidth = 1.7f, .fillFull = .34f, .fillSpent = .03f,       \
        .cover = .85f)                                                                                               \
  SHAPE(dart, .name = "dart", .cornerCount = 3, .corners = {{1, 0}, {-.9f, .66f}, {-.38f, 0}}, .radius = 1.117f,     \
        .fillFull = .40f, .fillSpent = .05f, .cover = .6f)                                                           \
  SHAPE(checkered, .name = "checkered", .fold = Fold::diagonal, .cornerCount = 2, .corners = {{1, 0}, {1, 1}},       \
        .radius = 1.415f, .lineWidth = .8f, .fillFull = .75f, .fillSpent = .10f, .turns = false, .chequered = true)  \
  SHAPE(star, .name = "star", .fold = Fold::diagonal, .cornerCount = 2, .corners = {{1.1f, 0}, {.3f, .3f}},          \
        .radius = 1.1f, .fillFull = .36f, .fillSpent = .04f)                                                         \
  SHAPE(doubleRing, .name = "double_ring", .lineWidth = .85f, .fillFull = .24f, .fillSpent = .03f, .innerRing = .5f) \
  SHAPE(shot, .fold = Fold::across, .cornerCount = 3, .corners = {{1, 0}, {1, .18f}, {0, .18f}}, .radius = 1.02f,    \
        .fillFull = .9f, .fillSpent = .9f, .cover = .5f, .glowReach = .8f)                                           \
  SHAPE(bit, .fold = Fold::diagonal, .cornerCount = 2, .corners = {{1, 0}, {.5f, .5f}}, .lineWidth = .8f,            \
        .fillFull = .55f, .fillSpent = .55f, .cover = .3f, .turns = false)                                           \
  SHAPE(ship, .cornerCount = 4, .corners = {{-.05f, 0}, {1, .34f}, {-.7f, 1}, {-.38f, 0}}, .radius = 1.221f,         \
        .lineWidth = 1.25f, .fillFull = .16f, .fillSpent = .16f, .cover = .85f, .glowReach = 2.2f)

#define GW_NUMBER(name, ...) name,
enum class Shape : uint32_t { GW_SPRITE_SHAPES(GW_NUMBER) count };
#undef GW_NUMBER
inline constexpr uint32_t kShapes = uint32_t(Shape::count);

#define GW_ROW(name, ...) {__VA_ARGS__},
inline constexpr SpriteShape kSpriteShapes[kShapes] = {GW_SPRITE_SHAPES(GW_ROW)};
#undef GW_ROW

constexpr uint32_t countEnemyShapes() {
  uint32_t count = 0;
  while (count < kShapes && kSpriteShapes[count].name) ++count;
  return count;
}
inline constexpr uint32_t kEnemyShapes = countEnemyShapes();

// An announced enemy is an outline that starts so much larger than the shape, and closes in until it is harmful.
inline constexpr float kAnnouncedScale = 2;

// What no table of enemies says of the others. The hull of the ship is drawn larger than what can be hit.
inline constexpr float kShipScale = 1.6f, kBitSize_m = 0.22f;
inline constexpr uint32_t kShipColour = 0xE8F6FF, kShotColour = 0xFFF3B0, kBitColour = 0x7CFFCB;  // 0xRRGGBB

}  // namespace gw
