// What a stage left, value by value.
#pragma once

#include "game/sim/debug/inspection.h"
#include "game/sim/state.h"

namespace gw::GW_DEVICE {

// `v` is the running tick's.
StageState readState(const GameState& state, const View& v, const std::string& stage, const StageState* before);

// The parts of all buffers; and what else the device's memory holds, where that can be listed.
std::vector<BytesOfBuffer> bytesOf(Queue& queue, const GameState& state, const View& v);

}  // namespace gw::GW_DEVICE
