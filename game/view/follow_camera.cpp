#include "game/view/follow_camera.h"

#include <algorithm>
#include <cmath>

namespace gw {

namespace {

// One axis of the centre, so that at most `past` is seen beyond either wall; a view wider than that is
// centred on the world.
float clampAxis(float centre, float half, float world, float past) {
  const float low = half - past, high = world - half + past;
  return low > high ? world / 2 : std::clamp(centre, low, high);
}

}  // namespace

FollowCamera::FollowCamera(float worldWidth_m, float worldHeight_m, const CameraRules& rules)
    : rules_(rules),
      worldWidth_m_(worldWidth_m),
      worldHeight_m_(worldHeight_m),
      x_(worldWidth_m / 2),
      y_(worldHeight_m / 2),
      height_(rules.height_m) {}

void FollowCamera::snap(const Target& target, float aspect) {
  aspect_ = aspect;
  height_ = wishedHeight(target.enemiesInView);
  x_ = target.ship_x + rules_.lookAhead_m * std::cos(target.aim_rad);
  y_ = target.ship_y + rules_.lookAhead_m * std::sin(target.aim_rad);
  clampToWorld();
}

void FollowCamera::follow(const Target& target, float aspect, float dt_s) {
  aspect_ = aspect;
  const float dt = std::clamp(dt_s, 0.0f, 1.0f);
  // A decay, not a share per frame: the same path at every frame rate.
  const float follow = 1 - std::exp(-rules_.spring_per_s * dt);
  const float widen = 1 - std::exp(-rules_.widening_per_s * dt);
  x_ += (target.ship_x + rules_.lookAhead_m * std::cos(target.aim_rad) - x_) * follow;
  y_ += (target.ship_y + rules_.lookAhead_m * std::sin(target.aim_rad) - y_) * follow;
  height_ += (wishedHeight(target.enemiesInView) - height_) * widen;
  clampToWorld();
}

void FollowCamera::place(const CameraPlace& place, float aspect) {
  aspect_ = aspect;
  x_ = place.x;
  y_ = place.y;
  height_ = place.height_m;
}

void FollowCamera::toWorld(float px, float py, float width_px, float height_px, float& world_x, float& world_y) const {
  world_x = x_ + (px / width_px * 2 - 1) * halfWidth_m();
  world_y = y_ - (py / height_px * 2 - 1) * halfHeight_m();
}

void FollowCamera::toPixels(float world_x, float world_y, float width_px, float height_px, float& px, float& py) const {
  px = ((world_x - x_) / halfWidth_m() + 1) / 2 * width_px;
  py = (1 - (world_y - y_) / halfHeight_m()) / 2 * height_px;
}

float FollowCamera::wishedHeight(uint32_t enemiesInView) const {
  const float span = float(rules_.wideEnemies - rules_.nearEnemies);
  const float share = std::clamp((float(enemiesInView) - float(rules_.nearEnemies)) / span, 0.0f, 1.0f);
  return rules_.height_m + (rules_.wideHeight_m - rules_.height_m) * share;
}

void FollowCamera::clampToWorld() {
  x_ = clampAxis(x_, halfWidth_m(), worldWidth_m_, rules_.pastWalls_m);
  y_ = clampAxis(y_, halfHeight_m(), worldHeight_m_, rules_.pastWalls_m);
}

}  // namespace gw
