// The scenes of a session. All are played by the expert bot.
#pragma once

#include <cstdint>

namespace gw::profile {

enum class SceneKind : uint32_t {
  fiveMinutes,  // as many enemies as fit, and every loss made good, for 18,000 ticks: the thesis's game figure
  ramp,         // from none to as many as fit, steadily
  swarm,        // all at once, until they or the ship are gone
  menu,         // what moves behind the title
};

}  // namespace gw::profile
