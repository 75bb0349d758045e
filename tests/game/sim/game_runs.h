// Whole games for the tests: scenes to start from, and runs of hashes to compare.
#pragma once

#include <memory>
#include <vector>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {

Snapshot snapshotOf(const naive::World& world);
GameGlobals globalsOf(const Snapshot& snapshot);

// A crowd of that many living enemies round the ship in the midst of the arcade, as a snapshot.
Snapshot crowdScene(const SimulationConfig& config, uint32_t enemies, uint32_t seed = 1);

// Plays on, with that input unless a bot plays, and keeps every report.
std::vector<TickReport> play(Simulation& simulation, uint32_t ticks, const std::vector<InputRecord>& inputs = {});

std::vector<uint64_t> hashesOf(const std::vector<TickReport>& reports);
std::vector<InputRecord> inputsOf(const std::vector<TickReport>& reports);

}  // namespace gw::test
