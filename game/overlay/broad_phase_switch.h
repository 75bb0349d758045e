// The same game by another broad phase, while it is played. The exact ones find the same neighbours, so they play the
// same game, hash for hash: the run goes on, and so does its recording.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "game/session/run.h"

namespace gw {

// ngrid -> grid -> grid-hashed -> brute -> ngrid
BroadPhase broadPhaseAfter(BroadPhase broadPhase);

// Games for more enemies than this are not switched to brute force, whose ticks would take seconds.
inline constexpr uint32_t kMostForBruteForce = 65536;

// Makes a simulation the way that the run's own was made.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(const SimulationConfig&)>;

// Goes on with the next broad phase from where the run is; no tick may be queued. What to tell the player: what plays
// now, or why nothing has changed (an inexact game has only one broad phase; no room for a second simulation).
std::string switchBroadPhase(Run& run, const MakeSimulation& make);

}  // namespace gw
