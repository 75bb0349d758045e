// One tick of the game.
#pragma once

#include <string>

#include "game/sim/draw/particles.h"
#include "game/sim/state.h"
#include "gpu/exec/stage_timer.h"

namespace gw::GW_DEVICE {

// Launches every stage of the tick with this parity (tick number modulo 2). `particles` may be null: none.
void step(Queue& queue, GameState& state, uint32_t parity, Autopilot who, StageTimer& timer, Particles* particles);

// The place of a stage in the list of step.cu, by the name that its time is reported under. Throws std::logic_error
// when there is none of that name.
uint32_t stageNumber(const std::string& name);

}  // namespace gw::GW_DEVICE
