// When a moving circle touches a body: the earliest time in 0..1 of one tick. Everything is relative to the
// body's centre, so that a moving body is at rest in its own frame.
#pragma once

#include <cmath>

#include "game/sim/rules.h"
#include "gpu/math/bits.h"

namespace gw::GW_DEVICE {

inline constexpr float kNoContact = 2.0f;  // any time past the end of the tick

// A point at (x, y) that moves by (dx, dy), against a circle of this radius round the origin.
GW_FN float sweepCircle(float x, float y, float dx, float dy, float radius) {
  const float outside = x * x + y * y - radius * radius;
  if (outside <= 0.0f) return 0.0f;
  const float a = dx * dx + dy * dy, b = x * dx + y * dy;
  if (!(a > 0.0f) || b >= 0.0f) return kNoContact;  // still, or moving away
  const float discriminant = b * b - a * outside;
  if (discriminant < 0.0f) return kNoContact;
  const float t = (-b - sqrtf(discriminant)) / a;
  return t <= 1.0f ? (t > 0.0f ? t : 0.0f) : kNoContact;
}

// The same against an axis-aligned rectangle (slabs: Kay and Kajiya 1986).
GW_FN float sweepBox(float x, float y, float dx, float dy, float halfWidth, float halfHeight) {
  float enter = 0.0f, leave = 1.0f;
  const float position[2] = {x, y}, step[2] = {dx, dy}, half[2] = {halfWidth, halfHeight};
  for (int axis = 0; axis < 2; ++axis) {
    if (step[axis] == 0.0f) {
      if (magnitude(position[axis]) > half[axis]) return kNoContact;
      continue;
    }
    const float a = (-half[axis] - position[axis]) / step[axis], b = (half[axis] - position[axis]) / step[axis];
    enter = larger(enter, smaller(a, b));
    leave = smaller(leave, larger(a, b));
  }
  return enter <= leave ? enter : kNoContact;
}

// A circle against a body: the point against the body grown by the circle's radius. A grown rectangle is
// two boxes and four circles at its corners.
GW_FN float sweepBody(float x, float y, float dx, float dy, float radius, const EnemyRules& body) {
  const float w = body.halfWidth_m, h = body.halfHeight_m;
  if (body.bounds == Bounds::circle) return sweepCircle(x, y, dx, dy, w + radius);
  float first = smaller(sweepBox(x, y, dx, dy, w + radius, h), sweepBox(x, y, dx, dy, w, h + radius));
  for (int corner = 0; corner < 4; ++corner) {
    const float cx = corner & 1 ? w : -w, cy = corner & 2 ? h : -h;
    first = smaller(first, sweepCircle(x - cx, y - cy, dx, dy, radius));
  }
  return first;
}

}  // namespace gw::GW_DEVICE
