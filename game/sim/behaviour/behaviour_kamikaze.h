// Kamikaze: wanders, drifting towards the ship; once it sees the ship it flies straight at it, and faster
// when damaged.
#pragma once

#include "game/sim/behaviour/behaviour.h"

namespace gw::GW_DEVICE {

GW_FN DesiredMotion kamikazeAttack(const Self& self, const EnemyRules& rules, const Rules::Steering& steering) {
  const float speed = self.speed_mps * (self.energy < rules.energy ? steering.damagedSpeed : 1.0f);
  return along(normalised(self.ship_x, self.ship_y), speed);
}

}  // namespace gw::GW_DEVICE
