// How deep two bodies overlap, and which way the first must go to be free of the second. Odd: exchanging
// the bodies turns the vector round to the last bit, so that the forces of a pair cancel.
#pragma once

#include "game/sim/rules.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {

// (dx, dy) from the middle of b to the middle of a. A zero vector when they do not overlap. `odd` tells
// which of two coincident bodies goes which way: +1 for one of them, -1 for the other.
GW_FN Float2 overlap(const EnemyRules& a, const EnemyRules& b, float dx, float dy, float odd) {
  if (magnitude(dx) >= a.halfWidth_m + b.halfWidth_m || magnitude(dy) >= a.halfHeight_m + b.halfHeight_m) {
    return {0.0f, 0.0f};  // their boxes are apart: the common case, without a root
  }
  if (a.bounds == Bounds::rectangle && b.bounds == Bounds::rectangle) {
    const float deep_x = a.halfWidth_m + b.halfWidth_m - magnitude(dx);
    const float deep_y = a.halfHeight_m + b.halfHeight_m - magnitude(dy);
    if (deep_x < deep_y) return {dx > 0.0f || (dx == 0.0f && odd > 0.0f) ? deep_x : -deep_x, 0.0f};
    return {0.0f, dy > 0.0f || (dy == 0.0f && odd > 0.0f) ? deep_y : -deep_y};
  }
  if (a.bounds == Bounds::rectangle || b.bounds == Bounds::rectangle) {
    // From the nearest point of the rectangle to the circle's middle, then turned so that it points to a.
    const bool boxIsA = a.bounds == Bounds::rectangle;
    const EnemyRules& box = boxIsA ? a : b;
    const EnemyRules& ball = boxIsA ? b : a;
    const float x = boxIsA ? -dx : dx, y = boxIsA ? -dy : dy;  // from the box to the ball
    const float turned = boxIsA ? -1.0f : 1.0f;
    const float near_x = clamp(x, -box.halfWidth_m, box.halfWidth_m),
                near_y = clamp(y, -box.halfHeight_m, box.halfHeight_m);
    const float out_x = x - near_x, out_y = y - near_y, distance = length(out_x, out_y);
    if (distance > 0.0f) {
      const float deep = ball.halfWidth_m - distance;
      if (deep <= 0.0f) return {0.0f, 0.0f};
      return {turned * (out_x / distance * deep), turned * (out_y / distance * deep)};
    }
    // The middle is inside: leave by the nearest side.
    const float side_x = box.halfWidth_m - magnitude(x), side_y = box.halfHeight_m - magnitude(y);
    const float sign = boxIsA ? -odd : odd;
    if (side_x < side_y) {
      const float deep = side_x + ball.halfWidth_m;
      return {turned * (x > 0.0f || (x == 0.0f && sign > 0.0f) ? deep : -deep), 0.0f};
    }
    const float deep = side_y + ball.halfWidth_m;
    return {0.0f, turned * (y > 0.0f || (y == 0.0f && sign > 0.0f) ? deep : -deep)};
  }
  const float reach = a.halfWidth_m + b.halfWidth_m, distance = length(dx, dy);
  if (distance >= reach) return {0.0f, 0.0f};
  if (!(distance > 0.0f)) return {odd * reach, 0.0f};
  return {dx / distance * (reach - distance), dy / distance * (reach - distance)};
}

}  // namespace gw::GW_DEVICE
