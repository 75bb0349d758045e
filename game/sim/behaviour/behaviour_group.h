// Group: gathers with its own kind and flies as they fly (cohesion and alignment: Reynolds 1987; separation
// is the contact response of collide), attacks along with them, and steps out of the path of bullets. The
// tricky ones group and avoid in the same way.
#pragma once

#include "game/sim/behaviour/behaviour.h"

namespace gw::GW_DEVICE {

// Wandering, drawn to the middle of its kind and turned along their heading, which it takes over: so that a
// group converges on one.
GW_FN DesiredMotion flyInFlock(const Self& self, const Flock& flock, const Rules::Steering& steering, uint64_t seed,
                               uint32_t tick) {
  const Float2 heading = drifted(self, steering.wanderDrift_rad, seed, tick);
  const Float2 toShip = normalised(self.ship_x, self.ship_y), middle = flock.towardsCentre(),
               meanHeading = flock.meanHeading();
  const Float2 direction = normalised(
      heading.x + steering.wanderToShip * toShip.x + steering.cohesion * middle.x + steering.alignment * meanHeading.x,
      heading.y + steering.wanderToShip * toShip.y + steering.cohesion * middle.y + steering.alignment * meanHeading.y);
  return along(direction, self.speed_mps * steering.wanderSpeed);
}

// Until it gathers its own kind again.
GW_FN DesiredMotion keepHeading(const Self& self, const Rules::Steering& steering) {
  return along({self.direction_x, self.direction_y}, self.speed_mps * steering.wanderSpeed);
}

GW_FN DesiredMotion groupAttack(const Self& self, const Flock& flock, const Rules::Steering& steering) {
  const Float2 toShip = normalised(self.ship_x, self.ship_y), meanHeading = flock.meanHeading();
  const Float2 direction = normalised(toShip.x + steering.attackAlignment * meanHeading.x,
                                      toShip.y + steering.attackAlignment * meanHeading.y);
  return along(direction, self.speed_mps);
}

// Across the path of a shot that flies along `shotDirection` and lies at `offset` (from the shot to the entity):
// out on the side where it already is.
GW_FN Float2 awayFromPath(Float2 shotDirection, Float2 offset, uint32_t id) {
  const float across = shotDirection.x * offset.y - shotDirection.y * offset.x;  // > 0: it is to the left of the path
  const bool left = across > 0.0f || (across == 0.0f && (id & 1u) != 0);
  return left ? Float2{-shotDirection.y, shotDirection.x} : Float2{shotDirection.y, -shotDirection.x};
}

// Its direction was chosen when it began to avoid.
GW_FN DesiredMotion avoid(const Self& self, const Rules::Steering& steering) {
  return along({self.direction_x, self.direction_y}, steering.avoid_mps);
}

}  // namespace gw::GW_DEVICE
