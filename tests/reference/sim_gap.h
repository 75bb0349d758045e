// The gap between a moving circle and a body, in double precision and by small steps: what the sweep of the
// narrow phase must agree with. It knows no algebra, so it cannot share a mistake with it.
#pragma once

#include <algorithm>
#include <cmath>

#include "game/sim/rules.h"

namespace gw::naive {

// From a circle at (x, y) to the body at the origin; negative: they overlap.
inline double gapAt(double x, double y, double radius, const EnemyRules& body) {
  if (body.bounds == Bounds::circle) return std::hypot(x, y) - radius - double(body.halfWidth_m);
  const double out_x = std::fabs(x) - double(body.halfWidth_m), out_y = std::fabs(y) - double(body.halfHeight_m);
  const double outside = std::hypot(std::max(out_x, 0.0), std::max(out_y, 0.0));
  return outside + std::min(std::max(out_x, out_y), 0.0) - radius;
}

struct ClosestGap {
  double gap;   // the smallest on the way
  double time;  // when it first was below zero, in 0..1; 2: never
};

// On the way from (x, y) along (dx, dy), looked at every `step_m`.
inline ClosestGap closestGap(double x, double y, double dx, double dy, double radius, const EnemyRules& body,
                             double step_m) {
  const int steps = 1 + int(std::hypot(dx, dy) / step_m);
  ClosestGap found{1e9, 2.0};
  for (int k = 0; k <= steps; ++k) {
    const double t = double(k) / steps, gap = gapAt(x + dx * t, y + dy * t, radius, body);
    if (gap < 0.0 && found.time > 1.0) found.time = t;
    found.gap = std::min(found.gap, gap);
  }
  return found;
}

}  // namespace gw::naive
