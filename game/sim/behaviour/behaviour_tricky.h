// Tricky: closes in sideways, and flees from the ship to recover when its energy is low.
#pragma once

#include "game/sim/behaviour/behaviour.h"

namespace gw::GW_DEVICE {

// Far away it flies aslant, which spoils a player's aim; half of them to either side.
GW_FN DesiredMotion trickyAttack(const Self& self, const Rules::Steering& steering) {
  const Float2 toShip = normalised(self.ship_x, self.ship_y);
  const float side = self.shipDistance_m > steering.sidewaysBeyond_m ? steering.sideways : 0.0f;
  const float across = (self.id & 1u) != 0 ? side : -side;
  return along(normalised(toShip.x - across * toShip.y, toShip.y + across * toShip.x), self.speed_mps);
}

// One axis of the direction away from the ship: near the wall that it leads to it is closed.
GW_FN float openDirection(float away, float position, float size, float wall_m) {
  const bool closed = away < 0.0f ? position < wall_m : position > size - wall_m;
  return closed ? 0.0f : away;
}

// Straight away from the ship; along a wall where one is in the way; in a corner towards the middle of the
// world, along the wall that leads away from the ship sooner.
GW_FN DesiredMotion escape(const Self& self, const Rules::Steering& steering, const Limits& limits) {
  const Float2 away = normalised(-self.ship_x, -self.ship_y);
  Float2 direction = {openDirection(away.x, self.x, limits.width_m, steering.escapeWall_m),
                      openDirection(away.y, self.y, limits.height_m, steering.escapeWall_m)};
  if (direction.x == 0.0f && direction.y == 0.0f) {
    if (magnitude(away.x) < magnitude(away.y)) {
      direction.x = 2.0f * self.x < limits.width_m ? 1.0f : -1.0f;
    } else {
      direction.y = 2.0f * self.y < limits.height_m ? 1.0f : -1.0f;
    }
  }
  return along(normalised(direction.x, direction.y), self.speed_mps * steering.escapeSpeed);
}

}  // namespace gw::GW_DEVICE
