// A crowd in a square. In each step every walker is pushed away by all others nearer than a metre.
//
//   upkeep       the grid brings the cells back into order, for they have moved
//   push         one item, one cell: its neighbours, each through a visitor
//   step         one item, one cell: moves it
//
// gw_add_kernels() compiles this file once per device. The result has the same bits on all of them, because pushes are
// summed as integers (the order of visits differs) and because arithmetic is + - * / and sqrtf only.
#include <gpuwars/exact_math.h>
#include <gpuwars/fixed_sum.h>
#include <gpuwars/ngrid.h>
#include <gpuwars/philox.h>
#include <gpuwars/row_gather.h>
#include <gpuwars/state_hash.h>

#include <cmath>
#include <vector>

#include "crowd.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kSide_m = 50.0f, kRoom_m = 1.0f;
constexpr float kShare = 0.25f;            // of an overlap that one step takes from each side
constexpr float kUnitsPerMetre = 0x1p20f;  // of the integer sums; a power of two

// The direction in which a walker leaves another in the same place, which leaves in the opposite one. It comes from
// both ids: a fixed direction would keep all who started in one place on one line for ever.
GW_FN Float2 partingOf(uint32_t id, uint32_t other) {
  const bool first = id < other;
  const Uint4 random = philox(2, {first ? id : other, first ? other : id, 0, 0});
  const SineCosine angle = sineCosine(unitFloat(random.x) * kTwoPi);
  return first ? Float2{angle.cosine, angle.sine} : Float2{-angle.cosine, -angle.sine};
}

// One item: one cell. Cells that fill the last row are dead, and push no one.
struct Push {
  Float2* pushes_m;  // by id
  RowGather<Cell> search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell self = search.grid.cells[i];
    if (!isLiving(self.x)) return;
    FixedSum2 sum;
    search.around(i, placeOf(self), kRoom_m, [&](const Cell& other, uint32_t, Float2 away) {
      if (other.id == self.id) return;
      const float distance = sqrtf(away.x * away.x + away.y * away.y);
      if (distance > 0.0f) {
        const float part = kShare * (kRoom_m - distance) / distance;
        sum.add(-away.x * part, -away.y * part, kUnitsPerMetre);
      } else {
        const Float2 parting = partingOf(self.id, other.id);
        sum.add(parting.x * kShare * kRoom_m, parting.y * kShare * kRoom_m, kUnitsPerMetre);
      }
    });
    pushes_m[self.id] = sum.total(kUnitsPerMetre);
  }
};

// One item: one cell.
struct Step {
  Cell* cells;
  const Float2* pushes_m;

  GW_BODY void operator()(uint32_t i) const {
    Cell& self = cells[i];
    if (!isLiving(self.x)) return;
    self.x = clamp(self.x + pushes_m[self.id].x, 0.0f, kSide_m);
    self.y = clamp(self.y + pushes_m[self.id].y, 0.0f, kSide_m);
  }
};

// One item: one cell, which looks for the nearest other.
struct Nearest {
  float* nearest_m;  // by id
  RowGather<Cell> search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell self = search.grid.cells[i];
    if (!isLiving(self.x)) return;
    float nearest = kSide_m;
    search.around(i, placeOf(self), 4.0f * kRoom_m, [&](const Cell& other, uint32_t, Float2 away) {
      if (other.id != self.id) nearest = smaller(nearest, sqrtf(away.x * away.x + away.y * away.y));
    });
    nearest_m[self.id] = nearest;
  }
};

std::vector<Cell> placesAt(Start start, uint32_t agents) {
  std::vector<Cell> places(agents);
  for (uint32_t i = 0; i < agents; ++i) {
    const Uint4 random = philox(1, {i, 0, 0, 0});
    const bool scattered = start == Start::scattered;
    places[i] = {scattered ? unitFloat(random.x) * kSide_m : kSide_m / 2,
                 scattered ? unitFloat(random.y) * kSide_m : kSide_m / 2, i, 0};
  }
  return places;
}

// The standard deviation of what has this sum and this sum of squares.
float deviation(double sum, double squares, uint32_t count) {
  const double mean = sum / count;
  return float(std::sqrt(larger(float(squares / count - mean * mean), 0.0f)));
}

}  // namespace

CrowdRun runCrowd(const ExecOptions& options, uint32_t agents, uint32_t steps, Start start) {
  Queue queue(options);
  const NDimensions dimensions = chooseDimensions(agents, {kSide_m, kSide_m, 0.0f}, kRoom_m);
  const Count all{dimensions.cells()};
  NGrid<Cell> grid(queue, dimensions, Kept::packed);
  Buffer<Cell> cells(queue, dimensions.cells());
  Buffer<uint32_t> cellOf(queue, dimensions.cells());
  Buffer<Float2> pushes(queue, dimensions.cells());
  Buffer<float> nearest(queue, agents);

  // Of the order in which the cells stand nothing enters the hash: that is how the crowd was found, not where it is.
  const auto report = [&] {
    forEach(queue, all, Nearest{nearest.data(), {grid.view(cells.data())}});
    CrowdReport now{0, kSide_m, 0.0f, 0.0f, 0.0f};
    for (const float distance : nearest.download()) {
      now.closest_m = smaller(now.closest_m, distance);
      now.loneliest_m = larger(now.loneliest_m, distance);
    }
    double sumX = 0.0, sumY = 0.0, squaresX = 0.0, squaresY = 0.0;
    for (const Cell& cell : cells.download()) {
      if (cell.id >= agents) continue;  // dead
      now.hash += hashWord(cell.id, 0, uint64_t(bitsOf(cell.x)) << 32 | bitsOf(cell.y));
      sumX += double(cell.x);
      sumY += double(cell.y);
      squaresX += double(cell.x) * double(cell.x);
      squaresY += double(cell.y) * double(cell.y);
    }
    now.spreadX_m = deviation(sumX, squaresX, agents);
    now.spreadY_m = deviation(sumY, squaresY, agents);
    return now;
  };

  cells.upload(padded(placesAt(start, agents), dimensions));
  grid.rebuild(queue, cells.data(), cellOf.data());
  CrowdRun run;
  run.before = report();
  for (uint32_t step = 0; step < steps; ++step) {
    forEach(queue, all, Push{pushes.data(), {grid.view(cells.data())}});
    forEach(queue, all, Step{cells.data(), pushes.data()});
    grid.pack(queue, cells.data(), cellOf.data());
  }
  run.after = report();
  return run;
}

}  // namespace gw::GW_DEVICE
