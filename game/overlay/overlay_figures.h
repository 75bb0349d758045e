// What the overlay says about how the game is computed, as plain data, and who gathers it: a few times a second, and
// rarer where looking is slow, so that it costs at most a twentieth of the time. Nothing of the game is changed by it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/sim/simulation.h"

namespace gw {

struct StageFigure {
  std::string name;
  double perTick_ms = 0;
};

struct OverlayFigures {
  bool known = false;  // false: not counted yet
  std::string device;
  size_t deviceBytes = 0;
  uint32_t enemiesThatFit = 0;
  BroadPhase broadPhase{};
  Gather gather{};
  Sort sort{};
  // Of the ticks since the look before; of the last ones that were played when none was.
  std::vector<StageFigure> stages;
  Census census;
  CandidateCount candidates;

  double stages_ms() const;            // of a tick, all together
  double candidatesPerEntity() const;  // 0 when none searched
  double neighboursPerEntity() const;  // the same
  uint32_t liveEnemies() const;
  // The share of those in an NGrid that stood before their predecessor, in percent; none where there is no NGrid.
  std::optional<double> misaligned_percent() const;
};

// What a tick's stages took on average between two readings of Simulation::stageTimes(). A stage that the first reading
// lacks began after it. Empty when no tick was timed in between. When the second is behind the first it is another
// simulation's, and is taken as it is.
std::vector<StageFigure> stageFigures(const std::vector<StageTime>& before, const std::vector<StageTime>& now);

class FigureGatherer {
 public:
  // Looks when it is time to, by any clock that runs forward.
  void look(Simulation& simulation, double now_s);
  // Another simulation begins: its figures have nothing to do with those so far.
  void forget() { *this = {}; }

  const OverlayFigures& figures() const { return figures_; }

  static constexpr double kEvery_s = 0.25;    // at most so often
  static constexpr double kShare = 1.0 / 20;  // of the time

 private:
  void gather(Simulation& simulation);

  OverlayFigures figures_;
  std::vector<StageTime> read_;
  double next_s_ = 0;
};

}  // namespace gw
