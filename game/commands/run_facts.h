// What a run was like, summed over its reports: what tests ask of a recorded game beyond its hashes.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "game/sim/simulation.h"

namespace gw {

struct RunFacts {
  TickReport last;
  double travelled_m = 0;
  uint64_t shots = 0, flushes = 0;
  Edges edges;

  void add(const TickReport& report);
};

// Appends them. Every edge that the state tables have is there, those never taken with 0.
void factsToJson(nlohmann::ordered_json& json, const RunFacts& facts, const SimulationConfig& config);

}  // namespace gw
