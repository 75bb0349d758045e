// What the properties draw: numbers over their whole range from the first case on (RapidCheck's own ranges
// grow with the case), shrinking towards the low end.
#pragma once

#include <rapidcheck.h>

#include "game/sim/rules.h"

namespace gw::test {

inline float number(float low, float high) {
  const auto share = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1000001));
  return low + (high - low) * float(*share) / 1.0e6f;
}

inline uint32_t below(uint32_t count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, count));
}

inline EnemyRules someBody() {
  EnemyRules body{};
  body.bounds = below(2) == 0 ? Bounds::circle : Bounds::rectangle;
  body.halfWidth_m = number(0.05f, 2.5f);
  body.halfHeight_m = body.bounds == Bounds::circle ? body.halfWidth_m : number(0.05f, 2.5f);
  return body;
}

}  // namespace gw::test
