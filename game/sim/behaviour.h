// What the behaviours share: running a state table, and steering towards a wished velocity.
#pragma once

#include "game/sim/state.h"
#include "gpu/exact_math.h"

namespace gw::GW_DEVICE {

// The first row that applies; the same state when none does.
GW_FN State nextState(const MachineTable& table, State state, uint32_t conditions) {
  for (uint32_t i = 0; i < table.count; ++i) {
    const Transition& row = table.rows[i];
    if ((row.from >> uint32_t(state) & 1u) && (row.needs & conditions) == row.needs) return row.to;
  }
  return state;
}

// What a think kernel knows of its entity.
struct Self {
  uint32_t id, type;
  float x, y;
  float velocity_x, velocity_y;
  float direction_x, direction_y;
  float energy, mass;
  float ship_x, ship_y, shipDistance_m;  // offset to the ship and its length
};

struct Wish {
  float velocity_x, velocity_y;    // m/s
  float direction_x, direction_y;  // the heading it keeps, unit length
};

// The force that closes `response` of the gap to the wished velocity in one tick: F = m a.
GW_FN Float2 steeringForce(const Self& self, const Wish& wish, float response) {
  const float perTick = self.mass * response * float(kTicksPerSecond);
  return {(wish.velocity_x - self.velocity_x) * perTick, (wish.velocity_y - self.velocity_y) * perTick};
}

}  // namespace gw::GW_DEVICE
