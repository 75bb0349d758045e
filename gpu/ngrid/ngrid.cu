// What an NGrid holds, and what it can say about itself.
#include <gpuwars/ngrid.h>
#include <gpuwars/scan_reduce.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "detail/line_order.h"
#include "detail/ngrid_reach.h"
#include "detail/ngrid_rows.h"

namespace gw::GW_DEVICE {
namespace {

// Before anything is allocated for them, and while their product may not fit 32 bits.
NDimensions checked(NDimensions dimensions) {
  const auto fits = [](uint32_t length) { return length >= 1 && length <= kLongestLine; };
  if (!fits(dimensions.columns) || !fits(dimensions.rows) || !fits(dimensions.slabs) ||
      uint64_t(dimensions.columns) * dimensions.rows * dimensions.slabs >= 1ull << 31) {
    throw std::invalid_argument("An NGrid has 1 to " + std::to_string(kLongestLine) +
                                " columns, rows and slabs, and fewer than 2147483648 cells; it was asked for " +
                                std::to_string(dimensions.columns) + " x " + std::to_string(dimensions.rows) + " x " +
                                std::to_string(dimensions.slabs) + ".");
  }
  return dimensions;
}

// In place the whole index stays small; a packed grid, whose rows are in order by parts only, wants them fine.
uint32_t partsFor(NDimensions dimensions, Kept kept) {
  constexpr uint32_t kIndexBytes = 24 * 1024;
  if (kept == Kept::packed) return dimensions.columns + dimensions.columns / 2;
  const uint32_t fit = kIndexBytes / 2 / dimensions.lines();
  return larger(smaller(fit, 2 * dimensions.columns), 1u);
}

// The sum and number of steps along each axis, of one row's cells from their predecessors.
struct StepSums {
  double sum[3];
  uint64_t steps[3];
  uint64_t misaligned;
};

// One team: one row. As many lanes on every device: sums of floats depend on who adds what.
template <class CellT>
struct MeasureLines {
  static constexpr uint32_t kLanes = 32;
  struct Shared {
    StepSums lane[kLanes];
  };
  StepSums* sums;  // [lines]
  const CellT* cells;
  NDimensions dimensions;

  template <class Less>
  GW_BODY static void look(StepSums& mine, uint32_t axis, const CellT& before, const CellT& cell, bool& misaligned) {
    if (!isLiving(cell.x)) return;
    misaligned |= Less{}(cell, before);
    if (!isLiving(before.x)) return;
    const float step = Less{}.along(cell) - Less{}.along(before);
    mine.sum[axis] += double(step < 0.0f ? -step : step);
    ++mine.steps[axis];
  }

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t columns = dimensions.columns, slabCells = columns * dimensions.rows, begin = team.index * columns;
    team.phase([&](uint32_t lane) {
      StepSums mine{};
      for (uint32_t c = lane; c < columns; c += kLanes) {
        const uint32_t i = begin + c;
        bool misaligned = false;
        if (c > 0) look<ByX>(mine, 0, cells[i - 1], cells[i], misaligned);
        if (i % slabCells >= columns) look<ByY>(mine, 1, cells[i - columns], cells[i], misaligned);
        if (i >= slabCells) look<ByZ>(mine, 2, cells[i - slabCells], cells[i], misaligned);
        mine.misaligned += misaligned;
      }
      s.lane[lane] = mine;
    });
    team.phase([&](uint32_t lane) {
      if (lane != 0) return;
      StepSums all = s.lane[0];
      for (uint32_t l = 1; l < kLanes; ++l) {
        for (int axis = 0; axis < 3; ++axis) {
          all.sum[axis] += s.lane[l].sum[axis];
          all.steps[axis] += s.lane[l].steps[axis];
        }
        all.misaligned += s.lane[l].misaligned;
      }
      sums[team.index] = all;
    });
  }
};

template <class CellT>
StepSums measure(Queue& queue, const CellT* d_cells, NDimensions dimensions) {
  requireCells(d_cells);
  Buffer<StepSums> sums(queue, dimensions.lines());
  forEachTeam(queue, dimensions.lines(), MeasureLines<CellT>{sums.data(), d_cells, dimensions});
  StepSums all{};
  for (const StepSums& row : sums.download()) {
    for (int axis = 0; axis < 3; ++axis) {
      all.sum[axis] += row.sum[axis];
      all.steps[axis] += row.steps[axis];
    }
    all.misaligned += row.misaligned;
  }
  return all;
}

// One item: one cell.
template <class CellT>
struct BuryNaN {
  CellT* cells;
  uint64_t* buried;
  GW_BODY void operator()(uint32_t i) const {
    const CellT cell = cells[i];
    const auto place = placeOf(cell);
    const bool bad = place.x != place.x || place.y != place.y || heightOf(place) != heightOf(place);
    if (bad) cells[i] = deadCell(cell, cell.id);
    buried[i] = bad;
  }
};

}  // namespace

template <class CellT>
NGrid<CellT>::NGrid(Queue& queue, NDimensions dimensions, Kept kept)
    : dimensions_(checked(dimensions)),
      kept_(kept),
      parts_(partsFor(dimensions, kept)),
      width_(queue, dimensions.lines()),
      height_(queue, dimensions.lines()),
      reach_(queue, dimensions.lines()),
      living_(queue, dimensions.lines()),
      moved_(queue, dimensions.lines()),
      arrived_(queue, 1 + dimensions.slabs),
      slab_(queue, dimensions.slabs),
      totals_(queue, 1),
      firstColumn_(queue, size_t(dimensions.lines()) * (parts_ + 1)),
      firstRow_(queue, size_t(dimensions.lines()) * kPartsPerRow) {
  if constexpr (kFlat<CellT>) {
    if (dimensions.slabs != 1) throw std::invalid_argument("An NGrid in two dimensions has one slab.");
  } else {
    depth_ = Buffer<Interval>(queue, dimensions.lines());
    firstSlab_ = Buffer<uint16_t>(queue, dimensions.slabs * kPartsPerRow);
    slabTotals_ = Buffer<GridTotals>(queue, dimensions.slabs);
  }
  if (kept == Kept::inPlace) return;
  aside_ = Buffer<CellT>(queue, dimensions.cells());
  if (!kFlat<CellT>) byZ_ = BinSort(queue, dimensions.cells(), dimensions.slabs * kLevelsPerLine + 1, false);
  byY_ = BinSort(queue, dimensions.cells(), dimensions.lines() * kLevelsPerLine + 1, false);
}

template <class CellT>
NGridView<CellT> NGrid<CellT>::view(const CellT* d_cells) const {
  NGridView<CellT> view{};
  view.cells = d_cells;
  view.columns = dimensions_.columns;
  view.rows = dimensions_.rows;
  view.slabs = dimensions_.slabs;
  view.height = height_.data();
  view.depth = depth_.data();
  view.living = living_.data();
  view.reach = reach_.data();
  view.slab = slab_.data();
  view.totals = totals_.data();
  view.firstColumn = firstColumn_.data();
  view.firstRow = firstRow_.data();
  view.firstSlab = firstSlab_.data();
  view.parts = parts_;
  view.sorted = kept_ == Kept::inPlace;
  return view;
}

template <class CellT>
RowsFound NGrid<CellT>::found() const {
  return {width_.data(), height_.data(),      depth_.data(), living_.data(),
          moved_.data(), firstColumn_.data(), parts_,        totals_.data()};
}

template <class CellT>
FindReach NGrid<CellT>::findReach(bool built) const {
  return {reach_.data(),  firstRow_.data(), firstSlab_.data(), slab_.data(),      slabTotals_.data(),
          totals_.data(), found(),          dimensions_.rows,  dimensions_.slabs, built};
}

template <class CellT>
size_t NGrid<CellT>::bytes() const {
  const size_t intervals = width_.size() + height_.size() + depth_.size() + reach_.size();
  return intervals * sizeof(Interval) + (living_.size() + moved_.size() + arrived_.size()) * sizeof(uint32_t) +
         slab_.size() * sizeof(GridSlab) + (totals_.size() + slabTotals_.size()) * sizeof(GridTotals) +
         (firstColumn_.size() + firstRow_.size() + firstSlab_.size()) * sizeof(uint16_t) + byZ_.bytes() + byY_.bytes() +
         aside_.size() * sizeof(CellT);
}

template <class CellT>
GridTotals NGrid<CellT>::totals() const {
  GridTotals totals;
  totals_.download(&totals, 1);
  return totals;
}

template <class CellT>
float NGrid<CellT>::rowsWidened() const {
  const GridTotals now = totals();
  NGridView<CellT> view{};
  view.totals = &now;
  return view.widened();
}

template <class CellT>
UpkeepReport NGrid<CellT>::upkeepReport(Queue& queue, const CellT* d_cells) {
  return {uint32_t(measure(queue, d_cells, dimensions_).misaligned), totals().moved, rounds_, rowsWidened()};
}

template <class CellT>
Steps NGrid<CellT>::steps(Queue& queue, const CellT* d_cells) {
  const StepSums sums = measure(queue, d_cells, dimensions_);
  Steps steps{};
  for (int axis = 0; axis < 3; ++axis) {
    if (sums.steps[axis]) steps.along[axis] = float(sums.sum[axis] / double(sums.steps[axis]));
  }
  return steps;
}

template <class CellT>
uint32_t NGrid<CellT>::quarantine(Queue& queue, CellT* d_cells) {
  requireCells(d_cells);
  const uint32_t n = dimensions_.cells();
  Buffer<uint64_t> buried(queue, n), sum(queue, 1);
  Reduce reduce(queue, n);
  forEach(queue, Count{n}, BuryNaN<CellT>{d_cells, buried.data()});
  reduce.run(queue, buried.data(), sum.data());
  return uint32_t(sum.download()[0]);
}

template <class CellT>
std::vector<CellT> padded(const std::vector<CellT>& entities, NDimensions dimensions) {
  checked(dimensions);
  if (entities.empty() || entities.size() > dimensions.cells()) {
    throw std::invalid_argument("An NGrid of " + std::to_string(dimensions.columns) + " x " +
                                std::to_string(dimensions.rows) + " x " + std::to_string(dimensions.slabs) +
                                " cells holds 1 to " + std::to_string(dimensions.cells()) + " entities; it was given " +
                                std::to_string(entities.size()) + ".");
  }
  std::vector<CellT> cells = entities;
  cells.resize(dimensions.cells());
  for (uint32_t i = 0; i < cells.size(); ++i) {
    const auto place = placeOf(cells[i]);
    if (i >= entities.size()) {
      cells[i] = deadCell(CellT{}, i);
    } else if (std::isnan(place.x) || std::isnan(place.y) || std::isnan(heightOf(place))) {
      throw std::invalid_argument("Entity " + std::to_string(i) +
                                  " has a place that is not a number; give it a place or leave it out.");
    }
    cells[i].id = i;
  }
  return cells;
}

template class NGrid<Cell>;
template class NGrid<Cell3>;
template std::vector<Cell> padded(const std::vector<Cell>&, NDimensions);
template std::vector<Cell3> padded(const std::vector<Cell3>&, NDimensions);

}  // namespace gw::GW_DEVICE
