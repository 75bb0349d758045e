// The collide stage with a search that is broken on purpose: the tests of collide must notice.
#pragma once

#include "game/sim/state.h"

namespace gw::cpu {

enum class Break { nothing, dropsLast, shortRadius, shortByHalf };

// As collide(), but the search forgets its last candidate, or looks less far, or not quite as far.
void brokenCollide(Queue& queue, const View& view, Break how);

}  // namespace gw::cpu
