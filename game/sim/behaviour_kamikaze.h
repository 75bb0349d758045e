// Kamikaze: wanders, drifting towards the ship; once it sees the ship it flies straight at it, and faster
// when damaged.
#pragma once

#include "game/sim/behaviour.h"
#include "game/sim/entity_flags.h"
#include "gpu/philox.h"

namespace gw::GW_DEVICE {

GW_FN uint32_t kamikazeConditions(const Self& self, uint32_t flags, const EnemyRules& rules, float sightLost) {
  uint32_t conditions = 0;
  if (flags & kFlagHit) conditions |= kDamaged;
  if (self.energy <= 0.0f) conditions |= kEnergyGone;
  if (self.shipDistance_m <= rules.sight_m) conditions |= kSeesShip;
  if (self.shipDistance_m > rules.sight_m * sightLost) conditions |= kLostShip;
  return conditions;
}

GW_FN Wish wander(const Self& self, const EnemyRules& rules, const Rules::Steering& steering, uint64_t seed,
                  uint32_t tick) {
  const float drift =
      (2.0f * unitFloat(philox(seed, {tick, self.id, kPurposeWander, 0}).x) - 1.0f) * steering.wanderDrift_rad;
  const SineCosine turn = sineCosine(drift);
  const Float2 heading = normalised(self.direction_x * turn.cosine - self.direction_y * turn.sine,
                                    self.direction_x * turn.sine + self.direction_y * turn.cosine);
  const Float2 toShip = normalised(self.ship_x, self.ship_y);
  const Float2 way =
      normalised(heading.x + steering.wanderToShip * toShip.x, heading.y + steering.wanderToShip * toShip.y);
  const float speed = rules.speed_mps * steering.wanderSpeed;
  return {way.x * speed, way.y * speed, heading.x, heading.y};
}

GW_FN Wish kamikazeWish(const Self& self, State state, const EnemyRules& rules, const Rules::Steering& steering,
                        uint64_t seed, uint32_t tick) {
  if (state != State::attacking) return wander(self, rules, steering, seed, tick);
  const Float2 way = normalised(self.ship_x, self.ship_y);
  const float speed = rules.speed_mps * (self.energy < rules.energy ? steering.damagedSpeed : 1.0f);
  return {way.x * speed, way.y * speed, way.x, way.y};
}

}  // namespace gw::GW_DEVICE
