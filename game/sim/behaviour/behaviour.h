// What the behaviours share: running a state table, and steering towards a wished velocity.
#pragma once

#include "game/sim/state.h"
#include "game/sim/sum_scales.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/fixed_sum.h"
#include "gpu/math/philox.h"

namespace gw::GW_DEVICE {

// The first row that applies; the same state when none does.
GW_FN State nextState(const MachineTable& table, State state, uint32_t conditions) {
  for (uint32_t i = 0; i < table.count; ++i) {
    const Transition& row = table.rows[i];
    if ((row.from >> uint32_t(state) & 1u) && (row.needs & conditions) == row.needs) return row.to;
  }
  return state;
}

// Whether a machine is one of a set (kDodgingMachines, kFlockingMachines).
GW_FN bool isOneOf(Machine machine, uint32_t machines) {
  return (machines >> uint32_t(machine) & 1u) != 0;
}

// How often an entity gathers its own kind, staggered by id: its states can change because of it that often.
constexpr uint32_t kAskEvery_ticks = 4;

// What a think kernel has read of its entity.
struct Self {
  uint32_t id, type;
  float x, y;
  float velocity_x, velocity_y;
  float direction_x, direction_y;
  float energy, mass;
  float ship_x, ship_y;         // offset to the ship
  float shipDistance_m = 0.0f;  // its length
  float speed_mps = 0.0f;       // of its type, at the pace of the present wave
};

// Its own kind within its vision, itself left out. The sums do not depend on the order of visits.
struct Flock {
  uint32_t count = 0;
  FixedSum2 offset;   // to each of them, m
  FixedSum2 heading;  // unit vectors

  GW_MEMBER void add(float dx, float dy, float heading_x, float heading_y) {
    ++count;
    offset.add(dx, dy, kSteerScale);
    heading.add(heading_x, heading_y, kSteerScale);
  }
  // Unit vectors towards their middle and along their heading; zero when there is none.
  GW_MEMBER Float2 towardsCentre() const { return unit(offset); }
  GW_MEMBER Float2 meanHeading() const { return unit(heading); }

 private:
  GW_MEMBER static Float2 unit(const FixedSum2& sum) {
    const Float2 total = sum.total(kSteerScale);
    return normalised(total.x, total.y);
  }
};

struct DesiredMotion {
  float velocity_x, velocity_y;    // m/s
  float direction_x, direction_y;  // the heading it keeps, unit length
};

GW_FN DesiredMotion along(Float2 direction, float speed_mps) {
  return {direction.x * speed_mps, direction.y * speed_mps, direction.x, direction.y};
}

// The moment in which it checks its energy.
GW_FN DesiredMotion coast(const Self& self) {
  return {self.velocity_x, self.velocity_y, self.direction_x, self.direction_y};
}

// The heading after this tick's drift.
GW_FN Float2 drifted(const Self& self, float most_rad, uint64_t seed, uint32_t tick) {
  const float drift = (2.0f * unitFloat(philox(seed, {tick, self.id, kPurposeWander, 0}).x) - 1.0f) * most_rad;
  const SineCosine turn = sineCosine(drift);
  return normalised(self.direction_x * turn.cosine - self.direction_y * turn.sine,
                    self.direction_x * turn.sine + self.direction_y * turn.cosine);
}

GW_FN DesiredMotion wander(const Self& self, const Rules::Steering& steering, uint64_t seed, uint32_t tick) {
  const Float2 heading = drifted(self, steering.wanderDrift_rad, seed, tick);
  const Float2 toShip = normalised(self.ship_x, self.ship_y);
  const Float2 direction =
      normalised(heading.x + steering.wanderToShip * toShip.x, heading.y + steering.wanderToShip * toShip.y);
  const float speed = self.speed_mps * steering.wanderSpeed;
  return {direction.x * speed, direction.y * speed, heading.x, heading.y};
}

// The force that closes `response` of the gap to the wished velocity in one tick: F = m a.
GW_FN Float2 steeringForce(const Self& self, const DesiredMotion& desired, float response) {
  const float perTick = self.mass * response * float(kTicksPerSecond);
  return {(desired.velocity_x - self.velocity_x) * perTick, (desired.velocity_y - self.velocity_y) * perTick};
}

}  // namespace gw::GW_DEVICE
