// The penetration of two bodies as a vector: how the first must move to be free of the second. Odd: exchanging
// the bodies turns the vector round to the last bit, so that the forces of a pair cancel.
#pragma once

#include "game/sim/rules.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {

// (dx, dy) from the middle of b to the middle of a. A zero vector when they do not overlap. `tieSign` tells
// which of two coincident bodies goes which way: +1 for one of them, -1 for the other.
GW_FN Float2 overlap(const EnemyRules& a, const EnemyRules& b, float dx, float dy, float tieSign) {
  if (magnitude(dx) >= a.halfWidth_m + b.halfWidth_m || magnitude(dy) >= a.halfHeight_m + b.halfHeight_m) {
    return {0.0f, 0.0f};  // their boxes are apart: the common case, without a root
  }
  if (a.bounds == Bounds::rectangle && b.bounds == Bounds::rectangle) {
    const float penetration_x = a.halfWidth_m + b.halfWidth_m - magnitude(dx);
    const float penetration_y = a.halfHeight_m + b.halfHeight_m - magnitude(dy);
    if (penetration_x < penetration_y)
      return {dx > 0.0f || (dx == 0.0f && tieSign > 0.0f) ? penetration_x : -penetration_x, 0.0f};
    return {0.0f, dy > 0.0f || (dy == 0.0f && tieSign > 0.0f) ? penetration_y : -penetration_y};
  }
  if (a.bounds == Bounds::rectangle || b.bounds == Bounds::rectangle) {
    // From the nearest point of the rectangle to the circle's middle, then turned so that it points to a.
    const bool boxIsA = a.bounds == Bounds::rectangle;
    const EnemyRules& box = boxIsA ? a : b;
    const EnemyRules& ball = boxIsA ? b : a;
    const float x = boxIsA ? -dx : dx, y = boxIsA ? -dy : dy;  // from the box to the ball
    const float sign_a = boxIsA ? -1.0f : 1.0f;
    const float near_x = clamp(x, -box.halfWidth_m, box.halfWidth_m),
                near_y = clamp(y, -box.halfHeight_m, box.halfHeight_m);
    const float out_x = x - near_x, out_y = y - near_y, distance = length(out_x, out_y);
    if (distance > 0.0f) {
      const float penetration = ball.halfWidth_m - distance;
      if (penetration <= 0.0f) return {0.0f, 0.0f};
      return {sign_a * (out_x / distance * penetration), sign_a * (out_y / distance * penetration)};
    }
    // The middle is inside: leave by the nearest side.
    const float side_x = box.halfWidth_m - magnitude(x), side_y = box.halfHeight_m - magnitude(y);
    const float sign = boxIsA ? -tieSign : tieSign;
    if (side_x < side_y) {
      const float penetration = side_x + ball.halfWidth_m;
      return {sign_a * (x > 0.0f || (x == 0.0f && sign > 0.0f) ? penetration : -penetration), 0.0f};
    }
    const float penetration = side_y + ball.halfWidth_m;
    return {0.0f, sign_a * (y > 0.0f || (y == 0.0f && sign > 0.0f) ? penetration : -penetration)};
  }
  const float reach = a.halfWidth_m + b.halfWidth_m, distance = length(dx, dy);
  if (distance >= reach) return {0.0f, 0.0f};
  if (!(distance > 0.0f)) return {tieSign * reach, 0.0f};
  return {dx / distance * (reach - distance), dy / distance * (reach - distance)};
}

}  // namespace gw::GW_DEVICE
