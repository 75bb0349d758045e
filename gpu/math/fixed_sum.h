// Sums over neighbours that do not mind the order: each term becomes an integer, integers are added, the
// sum becomes a float once. A term is clamped to +-2^30 units and truncated, which is odd (term(-x) ==
// -term(x)), so that the two halves of a pair force cancel to the last bit. 2^33 terms fit.
#pragma once

#include <gpuwars/device.h>
#include <gpuwars/plain_types.h>

namespace gw::GW_DEVICE {

// The integer of one term. `scale` is units per physical unit, a power of two, so that scaling is exact: a term is
// clamped at 2^30 / scale and resolves 1 / scale. NaN counts as 0.
GW_FN int32_t fixedTerm(float value, float scale) {
  const float units = value * scale;
  if (!(units > -1073741824.0f)) return units != units ? 0 : -1073741824;
  if (!(units < 1073741824.0f)) return 1073741824;
  return int32_t(units);
}

// The sum of vectors. All of its calls take the same scale.
struct FixedSum2 {
  int64_t x = 0, y = 0;  // units so far

  // Adds one term.
  GW_MEMBER void add(float dx, float dy, float scale) {
    x += fixedTerm(dx, scale);
    y += fixedTerm(dy, scale);
  }
  // The sum in physical units, rounded once.
  GW_MEMBER Float2 total(float scale) const { return {float(x) / scale, float(y) / scale}; }
};

}  // namespace gw::GW_DEVICE
