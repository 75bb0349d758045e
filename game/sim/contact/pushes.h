// What pushes one body, summed so that neither the order nor the device matters.
#pragma once

#include "game/sim/sum_scales.h"
#include "gpu/math/fixed_sum.h"

namespace gw::GW_DEVICE {

// What pushes one body: their sum, and the sum of their lengths (|x| + |y|), which is longer the more of them cancel.
struct Pushes {
  FixedSum2 sum;
  int64_t lengths = 0;

  GW_MEMBER void add(float x_mps, float y_mps) {
    const int64_t x = fixedTerm(x_mps, kPushScale), y = fixedTerm(y_mps, kPushScale);
    sum.x += x;
    sum.y += y;
    lengths += magnitude64(x) + magnitude64(y);
  }
  // How hard it is pressed: what of the pushes cancels (m/s).
  GW_MEMBER float pressed_mps() const { return float(lengths - magnitude64(sum.x) - magnitude64(sum.y)) / kPushScale; }

 private:
  GW_MEMBER static int64_t magnitude64(int64_t x) { return x < 0 ? -x : x; }
};

}  // namespace gw::GW_DEVICE
