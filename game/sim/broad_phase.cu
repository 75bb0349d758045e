#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "game/sim/broad_phase.h"

namespace gw::GW_DEVICE {
namespace {

// The number of cells is the game's capacity, a rule: replays depend on it, so this stays as it is whatever
// chooseDimensions() learns. Whole rows, about 24 times as long as columns.
NDimensions dimensionsForRows(uint32_t n) {
  constexpr uint32_t kMostColumns = 2048;
  uint32_t columns = 16;
  while (uint64_t(columns) * columns < 24ull * n && columns + 32 <= kMostColumns) columns += 32;
  return {columns, (n + columns - 1) / columns};
}

Kept keptBy(Sort sort) {
  return sort == Sort::full || sort == Sort::frozen ? Kept::packed : Kept::inPlace;
}

const SimulationConfig& checked(const SimulationConfig& config) {
  const Sort sort = config.sortInUse();
  if (config.gather == Gather::exact && sort == Sort::oddEven) {
    throw std::invalid_argument("An exact gather needs rows in order, which odd-even transposition does not keep.");
  }
  if (config.gather != Gather::exact && sort != Sort::bitonic && sort != Sort::oddEven) {
    throw std::invalid_argument("A window needs columns in order, which a full sort and frozen rows do not keep.");
  }
  if (config.gather != Gather::exact && config.broadPhase != BroadPhase::ngrid) {
    throw std::invalid_argument("An inexact gather is the NGrid's: no other broad phase finds the same.");
  }
  return config;
}

}  // namespace

NDimensions dimensionsOf(const SimulationConfig& config) {
  const uint32_t n = config.enemies + kShotCapacity + kBitCapacity;
  if (!isArrangementState(config.gather)) return dimensionsForRows(n);
  return chooseWindowDimensions(n, {config.rules.world.width_m, config.rules.world.height_m, 0.0f});
}

std::vector<uint32_t> startArrangement(NDimensions dimensions) {
  const uint64_t columns = dimensions.columns, rows = dimensions.rows;
  // How large a corner has to be to hold a cell: along rows and columns in the same parts of the whole.
  const auto corner = [&](uint32_t cell) { return std::max(cell % columns * rows, cell / columns * columns); };
  std::vector<uint32_t> byCorner(dimensions.cells()), arrangement(dimensions.cells());
  std::iota(byCorner.begin(), byCorner.end(), 0u);
  std::stable_sort(byCorner.begin(), byCorner.end(), [&](uint32_t a, uint32_t b) { return corner(a) < corner(b); });
  for (uint32_t id = 0; id < byCorner.size(); ++id) arrangement[byCorner[id]] = id;
  return arrangement;
}

Neighbourhood::Neighbourhood(Queue& queue, const SimulationConfig& config, float width_m, float height_m)
    : broadPhase_(checked(config).broadPhase),
      gather_(config.gather),
      sort_(config.sortInUse()),
      dimensions_(dimensionsOf(config)) {
  const uint32_t n = dimensions_.cells();
  if (broadPhase_ == BroadPhase::ngrid) ngrid_ = NGrid<Cell>(queue, dimensions_, keptBy(sort_));
  if (broadPhase_ == BroadPhase::grid) {
    grid_ = UniformGrid<Cell>(queue, n, binsOver(Float2{0.0f, 0.0f}, Float2{width_m, height_m}, kBinSize_m, n));
  }
  if (broadPhase_ == BroadPhase::gridHashed) hashed_ = HashedGrid<Cell>(queue, n, kBinSize_m);
}

Searches Neighbourhood::searches(const Cell* d_cells) const {
  Searches all{};
  all.cells = d_cells;
  all.capacity = dimensions_.cells();
  all.broadPhase = broadPhase_;
  all.gather = gather_;
  if (broadPhase_ == BroadPhase::ngrid) all.ngrid = ngrid_.view(d_cells);
  if (broadPhase_ == BroadPhase::grid) all.grid = grid_.view(d_cells);
  if (broadPhase_ == BroadPhase::gridHashed) all.hashed = hashed_.view(d_cells);
  return all;
}

void Neighbourhood::arrange(Queue& queue, Cell* d_cells, uint32_t* d_cellOf) {
  if (broadPhase_ != BroadPhase::ngrid) {
    maintain(queue, d_cells, d_cellOf, nullptr);
  } else if (isArrangementState(gather_)) {
    ngrid_.sortUntilStable(queue, d_cells, d_cellOf);
  } else {
    ngrid_.rebuild(queue, d_cells, d_cellOf);
  }
}

std::optional<uint32_t> Neighbourhood::misaligned(Queue& queue, const Cell* d_cells) {
  if (broadPhase_ != BroadPhase::ngrid) return {};
  return ngrid_.upkeepReport(queue, d_cells).misaligned;
}

void Neighbourhood::maintainNGrid(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  switch (sort_) {
    case Sort::bitonic:
      return ngrid_.maintain(queue, d_cells, d_cellOf, d_hold);
    case Sort::oddEven:
      return ngrid_.transpose(queue, d_cells, d_cellOf, d_hold);
    case Sort::full:
      return ngrid_.pack(queue, d_cells, d_cellOf);
    case Sort::frozen:
      return sortInFull_ ? ngrid_.pack(queue, d_cells, d_cellOf) : ngrid_.refresh(queue, d_cells, d_cellOf);
  }
}

void Neighbourhood::maintain(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  switch (broadPhase_) {
    case BroadPhase::ngrid:
      return maintainNGrid(queue, d_cells, d_cellOf, isArrangementState(gather_) ? d_hold : nullptr);
    case BroadPhase::grid:
      return grid_.maintain(queue, d_cells, d_cellOf);
    case BroadPhase::gridHashed:
      return hashed_.maintain(queue, d_cells);
    case BroadPhase::bruteForce:
      return;  // has nothing to keep
  }
}

}  // namespace gw::GW_DEVICE
