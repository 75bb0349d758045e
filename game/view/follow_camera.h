// What part of the world is drawn. Drawing only: nothing here ever reaches the simulation, except that
// the mouse aims at the point under the pointer (which is then quantised and recorded as an angle).
#pragma once

#include <cstdint>

#include "render/camera.h"

namespace gw {

struct CameraRules {
  float height_m = 40;      // of the world, from the top of the window to the bottom
  float wideHeight_m = 52;  // with `wideEnemies` or more in view
  uint32_t nearEnemies = 600, wideEnemies = 2000;
  float lookAhead_m = 4;        // along the aim
  float spring_per_s = 8;       // share of the gap closed per second, as the exponent of a decay
  float widening_per_s = 1.2f;  // slower: a zoom that is noticed is a zoom too fast
  float pastWalls_m = 4;        // most that is shown beyond a wall
};

// A view that was chosen.
struct CameraPlace {
  float x = 0, y = 0;   // of the middle, m
  float height_m = 40;  // of the world, from the top of the window to the bottom
};

class FollowCamera {
 public:
  struct Target {
    float ship_x, ship_y, aim_rad;
    uint32_t enemiesInView;
  };

  // The world spans 0..width and 0..height, as the simulation has it.
  FollowCamera(float worldWidth_m, float worldHeight_m, const CameraRules& rules = {});

  // Goes there at once: the first frame of a run.
  void snap(const Target& target, float aspect);
  // Follows for `dt_s` seconds of real time. `aspect` is the window's width over its height.
  void follow(const Target& target, float aspect, float dt_s);

  // Looks where it is told to, walls or not; following begins from there.
  void place(const CameraPlace& place, float aspect);

  // What the passes draw.
  Camera view() const { return {x_, y_, halfWidth_m(), halfHeight_m()}; }
  float x() const { return x_; }
  float y() const { return y_; }
  float halfWidth_m() const { return height_ * aspect_ / 2; }
  float halfHeight_m() const { return height_ / 2; }

  // Pixels count from the window's top left corner.
  void toWorld(float px, float py, float width_px, float height_px, float& world_x, float& world_y) const;
  void toPixels(float world_x, float world_y, float width_px, float height_px, float& px, float& py) const;

 private:
  float wishedHeight(uint32_t enemiesInView) const;
  void clampToWorld();

  CameraRules rules_;
  float worldWidth_m_, worldHeight_m_;
  float x_, y_;
  float height_;
  float aspect_ = 16.0f / 9.0f;
};

}  // namespace gw
