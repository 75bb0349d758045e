// What a grid says about itself, against plain host code; what it refuses; and places that are no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "gpu/neighbours/neighbour.h"
#include "gpu/ngrid/ngrid.h"
#include "gpu/ngrid/row_gather.h"
#include "tests/gpu/both_dimensions.h"
#include "tests/gpu/refusal.h"
#include "tests/reference/ngrid_oracles.h"

namespace gw::cpu {
namespace {

using test::GridShape;
using test::In;
using test::Layout;
using test::refusal;
using test::Upkeep;

template <class CellT>
class NGridReport : public testing::Test {};
TYPED_TEST_SUITE(NGridReport, test::Dimensions);

TYPED_TEST(NGridReport, CountsTheMisalignedTheMovedAndTheSteps) {
  using In = test::In<TypeParam>;
  const GridShape shape = In::flat ? GridShape{44, 31} : GridShape{13, 11, 9};
  for (uint32_t layout = 0; layout < test::kLayouts; ++layout) {
    const auto cells = In::cells({Layout(layout), shape, layout % 2 * 20, layout + 1});
    for (Upkeep upkeep :
         {Upkeep::maintain, Upkeep::transpose, Upkeep::rebuild, Upkeep::pack, Upkeep::sortUntilStable}) {
      const test::GridReport report = In::report(probes())({2}, shape, cells, upkeep);
      const auto wanted = naive::upkeep(shape, cells, upkeep);
      EXPECT_EQ(report.moved, wanted.moved);
      EXPECT_EQ(report.misaligned, naive::misaligned(shape, wanted.cells)) << layout << ", " << uint32_t(upkeep);
      if (upkeep == Upkeep::sortUntilStable) {
        EXPECT_EQ(report.misaligned, 0u);
        EXPECT_GT(report.rounds, 1u);
      } else {
        EXPECT_EQ(report.rounds, 1u);
      }
      for (int axis = 0; axis < 3; ++axis) {
        const float step = float(naive::meanStep(shape, wanted.cells, axis));
        EXPECT_NEAR(report.steps[axis], step, 1e-5f * step) << axis;
      }
    }
  }
}

// The thesis: under 1 % of the entities after one bitonic pass per axis, over 10 % after odd-even. A crowd that has
// been sorted and moves by up to a third of the mean distance a tick.
TYPED_TEST(NGridReport, OfAMovingCrowdOddEvenLeavesMoreMisaligned) {
  using In = test::In<TypeParam>;
  const GridShape shape = In::flat ? GridShape{64, 64} : GridShape{16, 16, 16};
  const float reach = 30.0f / float(shape.rows);
  const auto share = [&](Upkeep upkeep) {
    auto cells =
        In::upkeep(probes())({2}, shape, In::cells({Layout::uniform, shape, 0, 3}), Upkeep::sortUntilStable).cells;
    uint32_t misaligned = 0;
    for (uint32_t frame = 0; frame < 20; ++frame) {
      for (auto& cell : cells) {  // as moveCells(), but none dies
        cell.x += reach * std::sin(float(cell.id) + 0.1f * float(frame));
        cell.y += reach * std::cos(float(cell.id) * 1.7f + 0.1f * float(frame));
      }
      cells = In::upkeep(probes())({2}, shape, cells, upkeep).cells;
      misaligned = naive::misaligned(shape, cells);
    }
    return double(misaligned) / shape.cells();
  };
  const double bitonic = share(Upkeep::maintain), oddEven = share(Upkeep::transpose);
  this->RecordProperty("misaligned_bitonic", std::to_string(bitonic));
  this->RecordProperty("misaligned_odd_even", std::to_string(oddEven));
  EXPECT_LT(bitonic, 0.08);
  EXPECT_LT(1.1 * bitonic, oddEven);
}

TEST(NGridRefusals, NameTheArgument) {
  Queue queue({1});
  const NDimensions d{8, 4};
  NGrid<Cell> grid(queue, d), packed(queue, d, Kept::packed);
  Buffer<Cell> cells(queue, d.cells());
  Buffer<uint32_t> cellOf(queue, d.cells());
  cells.upload(test::makeCells({Layout::uniform, {8, 4}, 0, 1}));
  const auto before = cells.download();
  using Call = void (NGrid<Cell>::*)(Queue&, Cell*, uint32_t*);
  for (Call call : {Call(&NGrid<Cell>::sortUntilStable), Call(&NGrid<Cell>::rebuild), Call(&NGrid<Cell>::pack),
                    Call(&NGrid<Cell>::refresh)}) {
    EXPECT_EQ(refusal<std::invalid_argument>([&] { (packed.*call)(queue, nullptr, cellOf.data()); }),
              "d_cells is null; give the grid a buffer with a cell for each of its own.");
    EXPECT_EQ(refusal<std::invalid_argument>([&] { (packed.*call)(queue, cells.data(), nullptr); }),
              "d_cellOf is null; give the grid a buffer with a word for each cell.");
  }
  EXPECT_NE(refusal<std::invalid_argument>([&] { grid.maintain(queue, nullptr, cellOf.data()); }), "not refused");
  EXPECT_NE(refusal<std::invalid_argument>([&] { grid.upkeepReport(queue, nullptr); }), "not refused");
  EXPECT_NE(refusal<std::invalid_argument>([&] { grid.steps(queue, nullptr); }), "not refused");
  EXPECT_NE(refusal<std::invalid_argument>([&] { grid.quarantine(queue, nullptr); }), "not refused");
  EXPECT_NE(refusal<std::invalid_argument>([&] { grid.transpose(queue, cells.data(), nullptr); }), "not refused");
  for (Call call : {Call(&NGrid<Cell>::pack), Call(&NGrid<Cell>::refresh)}) {
    EXPECT_EQ(refusal<std::logic_error>([&] { (grid.*call)(queue, cells.data(), cellOf.data()); }),
              "pack() and refresh() need a grid made with Kept::packed.");
  }
  EXPECT_EQ(refusal<std::logic_error>([&] { packed.pack(queue, cells.data(), cellOf.data()); }),
            "pack() goes by what is known of the rows; call rebuild() once before.");
  // Nothing was written.
  const auto after = cells.download();
  for (size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].id, after[i].id);
}

TEST(Padded, FillsTheGridWithTheDead) {
  const auto cells = padded(std::vector<Cell3>{{1, 2, 3, 77}, {4, 5, 6, 77}}, {2, 2, 2});
  ASSERT_EQ(cells.size(), 8u);
  for (uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(cells[i].id, i);
    EXPECT_EQ(isLiving(cells[i].x), i < 2);
  }
  EXPECT_EQ(cells[1].z, 6.0f);
}

TEST(Padded, RefusesTooFewTooManyAndNoNumbers) {
  const NDimensions d{3, 2};
  EXPECT_EQ(refusal<std::invalid_argument>([&] { padded(std::vector<Cell>{}, d); }),
            "An NGrid of 3 x 2 x 1 cells holds 1 to 6 entities; it was given 0.");
  EXPECT_EQ(refusal<std::invalid_argument>([&] { padded(std::vector<Cell>(7), d); }),
            "An NGrid of 3 x 2 x 1 cells holds 1 to 6 entities; it was given 7.");
  std::vector<Cell> entities(4);
  entities[2].y = std::nanf("");
  EXPECT_EQ(refusal<std::invalid_argument>([&] { padded(entities, d); }),
            "Entity 2 has a place that is not a number; give it a place or leave it out.");
}

// Those that are no numbers are dead afterwards, and all others find each other as if they had never been.
TYPED_TEST(NGridReport, QuarantinesWhatIsNoNumber) {
  using In = test::In<TypeParam>;
  const GridShape shape = In::flat ? GridShape{30, 20} : GridShape{10, 9, 7};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cells = In::cells({Layout::uniform, shape, 10, 4});
  uint32_t bad = 0;
  for (uint32_t i = 0; i < cells.size(); i += 7) {
    if (!isLiving(cells[i].x)) continue;
    (i % 2 ? cells[i].x : cells[i].y) = i % 3 ? nan : -nan;
    ++bad;
  }
  Queue queue({2});
  NGrid<TypeParam> grid(queue, {shape.columns, shape.rows, shape.slabs});
  Buffer<TypeParam> held(queue, cells.size());
  held.upload(cells);
  EXPECT_EQ(grid.quarantine(queue, held.data()), bad);
  EXPECT_EQ(grid.quarantine(queue, held.data()), 0u);
  auto clean = held.download();
  for (uint32_t i = 0; i < cells.size(); ++i) {
    const bool wasBad = std::isnan(cells[i].x) || std::isnan(cells[i].y);
    EXPECT_EQ(isLiving(clean[i].x), !wasBad && isLiving(cells[i].x));
    EXPECT_EQ(clean[i].id, cells[i].id);
  }
  EXPECT_EQ(checkGather(shape, clean, In::queries(clean, 200, 5), test::Method::rows), "");
}

}  // namespace
}  // namespace gw::cpu
