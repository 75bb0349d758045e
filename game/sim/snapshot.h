// The simulated state in canonical form: by id; the NGrid's arrangement only where it has an influence.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

// `next` is the view of the tick that comes next.
Snapshot takeSnapshot(const GameState& state, const View& next);

// Throws std::invalid_argument, leaving the state as it was, when the snapshot does not fit.
void restoreSnapshot(Queue& queue, GameState& state, const View& next, const Snapshot& snapshot);

}  // namespace gw::GW_DEVICE
