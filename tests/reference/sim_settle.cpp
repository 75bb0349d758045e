#include <cmath>

#include "game/sim/entity_flags.h"
#include "tests/reference/sim_world.h"

namespace gw::naive {

void settle(World& world) {
  Totals& t = world.globals.totals;
  const Ship& ship = world.globals.ship;
  for (const Entity& e : world.entities) {
    if (e.type == kTypeBit && e.taken) ++t.bitsTaken;
    if (e.gone) continue;
    ++t.occupied[e.type];
    if (!world.isEnemy(e)) continue;
    const float dx = e.x - ship.x, dy = e.y - ship.y;
    if (e.state == uint32_t(Mind::dead)) {
      ++t.dying;
      if (!e.died) continue;
      if (e.flags & kFlagBlasted) continue;
      if (e.flags & kFlagFlushed) {
        ++t.bareKills[e.type];
      } else {
        ++t.kills[e.type];
      }
      continue;
    }
    if (std::fabs(dx) <= world.rules.idle.halfWidth_m && std::fabs(dy) <= world.rules.idle.halfHeight_m) ++t.inView;
    if (world.isAnnounced(e) || e.state == uint32_t(Mind::attacking)) ++t.coming;
  }
  std::erase_if(world.entities, [](const Entity& e) { return e.gone; });
}

}  // namespace gw::naive
