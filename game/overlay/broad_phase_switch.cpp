#include "game/overlay/broad_phase_switch.h"

#include <stdexcept>
#include <utility>

#include "game/cli/computing_options.h"

namespace gw {

BroadPhase broadPhaseAfter(BroadPhase broadPhase) {
  switch (broadPhase) {
    case BroadPhase::ngrid:
      return BroadPhase::grid;
    case BroadPhase::grid:
      return BroadPhase::gridHashed;
    case BroadPhase::gridHashed:
      return BroadPhase::bruteForce;
    case BroadPhase::bruteForce:
      break;
  }
  return BroadPhase::ngrid;
}

std::string switchBroadPhase(Run& run, const MakeSimulation& make) {
  Simulation& old = run.simulation();
  SimulationConfig config = old.config();
  const std::string still = std::string("broad phase: still ") + nameOf(config.broadPhase);
  if (config.gather != Gather::exact) return still + ", because an inexact game has only one";
  config.broadPhase = broadPhaseAfter(config.broadPhase);
  const bool tooMany = config.broadPhase == BroadPhase::bruteForce && config.enemies > kMostForBruteForce;
  if (tooMany) config.broadPhase = broadPhaseAfter(config.broadPhase);
  try {
    std::unique_ptr<Simulation> next = make(config);
    if (next->onCuda() != old.onCuda()) return still + ", because the device has no room for a second game";
    next->restore(old.snapshot());
    next->enableStageTimes(old.timesStages());
    run.replaceSimulation(std::move(next));
  } catch (const std::runtime_error& error) {
    return still + ", because of this: " + error.what();
  }
  return std::string("broad phase: ") + nameOf(config.broadPhase) +
         (tooMany ? ", since brute would take seconds a tick" : "");
}

}  // namespace gw
