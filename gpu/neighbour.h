// What a neighbour is: one definition for every method, in rounded floats, so that all exact methods find
// the same set. Prune only by the same rounded differences: x_j - x < -r, never x_j < x - r.
#pragma once

#include "gpu/bits.h"

namespace gw::GW_DEVICE {

GW_FN bool isNeighbour(float dx, float dy, float radius) {
  // The most selective test stands first; the other two matter only where squares are rounded.
  return dx * dx + dy * dy <= radius * radius && magnitude(dx) <= radius && magnitude(dy) <= radius;
}

// A dead cell sits at +infinity.
GW_FN bool isLiving(float x) {
  return x < kInfinity;
}

}  // namespace gw::GW_DEVICE
