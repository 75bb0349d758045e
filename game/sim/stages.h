// The stages of a tick, in order. Each is one file of the same name; step.cu lists them.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

void autopilot(Queue& queue, const View& view, Autopilot who);
void logic(Queue& queue, const View& view);
void spawn(Queue& queue, const View& view, Scan& scan);
void maintain(Queue& queue, const View& view, Neighbourhood& neighbourhood);
void think(Queue& queue, const View& view);
void integrate(Queue& queue, const View& view);
void collide(Queue& queue, const View& view);
void settle(Queue& queue, const View& view);
void hash(Queue& queue, const View& view);
void report(Queue& queue, const View& view);

}  // namespace gw::GW_DEVICE
