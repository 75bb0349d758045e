// A camera that goes where the viewer of a replay wants to look. Drawing only.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "game/view/follow_camera.h"

namespace gw {

class FreeCamera {
 public:
  static constexpr float kNearest_m = 8;

  FreeCamera(float worldWidth_m, float worldHeight_m) : width_m_(worldWidth_m), height_m_(worldHeight_m) {}

  bool on() const { return place_.has_value(); }
  const std::optional<CameraPlace>& place() const { return place_; }

  // From where the picture is now.
  void free(const CameraPlace& from) {
    if (!on()) place_ = from;
  }
  void release() { place_.reset(); }

  // By shares of the height of the view; y up.
  void pan(float x, float y) {
    if (!on()) return;
    place_->x = std::clamp(place_->x + x * place_->height_m, 0.0f, width_m_);
    place_->y = std::clamp(place_->y + y * place_->height_m, 0.0f, height_m_);
  }

  // So many steps nearer, less further; what lies at (x, y) stays where it is on the screen.
  void zoom(float steps, float x, float y) {
    if (!on()) return;
    const float height = std::clamp(place_->height_m * std::pow(0.85f, steps), kNearest_m, furthest_m());
    const float share = height / place_->height_m;
    place_->x = std::clamp(x + (place_->x - x) * share, 0.0f, width_m_);
    place_->y = std::clamp(y + (place_->y - y) * share, 0.0f, height_m_);
    place_->height_m = height;
  }

  float furthest_m() const { return std::max(height_m_, kNearest_m) * 1.1f; }  // all of it, and some wall

 private:
  float width_m_, height_m_;
  std::optional<CameraPlace> place_;
};

}  // namespace gw
