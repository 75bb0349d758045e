// The structures that find neighbours. The game searches through withSearch() and does not know which one it uses: all
// exact ones give the same results, hash for hash.
#pragma once

#include "game/sim/game_globals.h"
#include "game/sim/simulation.h"
#include "gpu/neighbours/brute_force.h"
#include "gpu/neighbours/hashed_grid.h"
#include "gpu/neighbours/uniform_grid.h"
#include "gpu/ngrid/ngrid.h"
#include "gpu/ngrid/row_gather.h"
#include "gpu/ngrid/window_gather.h"

namespace gw::GW_DEVICE {

// Of both uniform grids: the vision of every type, and the radius of most searches.
inline constexpr float kBinSize_m = 4.0f;

// With an inexact gather the arrangement of the cells has an influence: it is state.
inline bool isArrangementState(Gather gather) {
  return gather != Gather::exact;
}

// Views of every structure over one column of cells; only those of the one in use are filled in.
struct Searches {
  const Cell* cells;
  uint32_t capacity;
  BroadPhase broadPhase;
  Gather gather;
  NGridView<Cell> ngrid;
  GridGather<Cell> grid;
  HashedGather<Cell> hashed;
};

// The row of the NGrid that a cell is in; of other structures, the row of bins that a place in it falls into.
// For drawing.
GW_FN uint32_t rowOf(const Searches& searches, uint32_t cell, float y) {
  if (searches.broadPhase == BroadPhase::ngrid) return cell / searches.ngrid.columns;
  return uint32_t(int32_t(clamp(y / kBinSize_m, 0.0f, 65535.0f)));
}

// Launches with the configured exact search.
template <class Launch>
void withExactSearch(const Searches& searches, const Launch& launch) {
  switch (searches.broadPhase) {
    case BroadPhase::ngrid:
      return launch(RowGather{searches.ngrid});
    case BroadPhase::grid:
      return launch(searches.grid);
    case BroadPhase::gridHashed:
      return launch(searches.hashed);
    case BroadPhase::bruteForce:
      return launch(BruteForce<Cell>{searches.cells, searches.capacity});
  }
}

// Launches with the configured search, from entities that stand in a cell: kernels call its around() and after(), which
// every search has.
template <class Launch>
void withSearch(const Searches& searches, const Launch& launch) {
  if (searches.gather == Gather::adaptive) return launch(AdaptiveGather{searches.ngrid});
  if (searches.gather == Gather::fixed) return launch(FixedGather{searches.ngrid});
  withExactSearch(searches, launch);
}

// The same from a position outside any cell. Inexact gathers have no window for it and test all entities.
template <class Launch>
void withSearchFromAnywhere(const Searches& searches, const Launch& launch) {
  if (isArrangementState(searches.gather)) return launch(BruteForce<Cell>{searches.cells, searches.capacity});
  withExactSearch(searches, launch);
}

// Exact gathers search by rows, windows by both axes, whose dimensions follow from the aspect of the world.
NDimensions dimensionsOf(const SimulationConfig& config);

// The id in each cell at the start of a game with an inexact gather: a corner of the grid with the grid's own shape
// holds the lowest ids, however many are alive, so that they fill it as they would fill all of it. The
// upkeep of empty cells leaves it as it is.
std::vector<uint32_t> startArrangement(NDimensions dimensions);

// The structure in use, and its upkeep.
class Neighbourhood {
 public:
  Neighbourhood() = default;
  // Throws std::invalid_argument when the gather, the sort and the broad phase do not go together.
  Neighbourhood(Queue& queue, const SimulationConfig& config, float width_m, float height_m);

  Searches searches(const Cell* d_cells) const;
  Gather gather() const { return gather_; }
  NDimensions dimensions() const { return dimensions_; }

  // After a start or a restored snapshot: from any arrangement. A gather that depends on the arrangement gets one that
  // suits it. Allocates while it runs, so it has no place in a tick.
  void arrange(Queue& queue, Cell* d_cells, uint32_t* d_cellOf);

  // The living that stand before their predecessor on a row or a column of the NGrid (NGrid::upkeepReport); none: it is
  // another structure. Waits for the queue.
  std::optional<uint32_t> misaligned(Queue& queue, const Cell* d_cells);

  // Frozen rows only: whether the next maintain() sorts in full. A capture of ticks captures both kinds.
  void sortInFull(bool next) { sortInFull_ = next; }

  // Once a tick, after motion. Nothing moves while the word at d_hold is not 0, where the arrangement is state.
  void maintain(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold);

 private:
  void maintainNGrid(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold);

  BroadPhase broadPhase_{};
  Gather gather_{};
  Sort sort_{};
  bool sortInFull_ = false;
  NDimensions dimensions_;
  NGrid<Cell> ngrid_;
  UniformGrid<Cell> grid_;
  HashedGrid<Cell> hashed_;
};

}  // namespace gw::GW_DEVICE
