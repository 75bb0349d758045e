// Sprites laid out by hand: every shape in every condition. What the golden picture shows.
#pragma once

#include <cstdint>
#include <iterator>
#include <vector>

#include "render/camera.h"
#include "render/sprite_shapes.h"
#include "render/sprite_vertex.h"

namespace gw {

struct SceneShape {
  float size_m;
  uint32_t colour;
};

// By shape number, sizes and colours close to those of the enemy table.
inline constexpr SceneShape kSceneShapes[] = {{.50f, 0xFFB020}, {.55f, 0xFF40C0}, {1.2f, 0xFF3030}, {.35f, 0x30E0FF},
                                              {.40f, 0x40FF60}, {.60f, 0xA060FF}, {.80f, 0xE8F0FF}, {.45f, 0xFFF0A0},
                                              {.22f, 0x60FFD0}, {.60f, 0xFFFFFF}};
inline constexpr uint32_t kSceneShapeCount = kShapes;
static_assert(std::size(kSceneShapes) == kShapes);
inline constexpr uint32_t kGrownUp_ticks = 255;

inline SpriteVertex sceneSprite(uint32_t shape, float x, float y, float angle_rad, uint32_t flags = 0,
                                uint32_t energy = 255, uint32_t age_ticks = kGrownUp_ticks) {
  return {x,
          y,
          x,
          y,
          angle_rad,
          kSceneShapes[shape].size_m,
          shape | flags << 8 | energy << 16 | age_ticks << 24,
          kSceneShapes[shape].colour};
}

// Columns are shapes; rows from the top: ahead, turned, spent, damaged, untouchable, announced early, announced
// late, moving (drawn between two places).
inline std::vector<SpriteVertex> shapeScene(float column_m = 3.2f, float row_m = 2.7f) {
  std::vector<SpriteVertex> sprites;
  for (uint32_t shape = 0; shape < kSceneShapeCount; ++shape) {
    const float x = (float(shape) - 4.5f) * column_m;
    float y = 3.5f * row_m;
    const auto add = [&](SpriteVertex sprite) {
      sprites.push_back(sprite);
      y -= row_m;
    };
    add(sceneSprite(shape, x, y, 0));
    add(sceneSprite(shape, x, y, 1.1f));
    add(sceneSprite(shape, x, y, .4f, 0, 25));
    add(sceneSprite(shape, x, y, .4f, kSpriteDamaged, 128));
    add(sceneSprite(shape, x, y, .4f, kSpriteUntouchable));
    add(sceneSprite(shape, x, y, .4f, kSpriteAnnounced, 255, 8));
    add(sceneSprite(shape, x, y, .4f, kSpriteAnnounced, 255, 22));
    SpriteVertex moving = sceneSprite(shape, x, y, 2.2f);
    moving.previous_x -= 1;
    add(moving);
  }
  return sprites;
}

}  // namespace gw
