// Boxes taken from data that has no thickness along some axes, or along any: all at one x, on a line, in one
// place, or alone. Dimensions are chosen all the same, and searches on them find what brute force finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "gpu/ngrid/ngrid.h"
#include "tests/gpu/both_dimensions.h"

namespace gw::test {
namespace {

const Probes kDevice = cpu::probes();

float& alongOf(Cell& cell, int axis) {
  return axis == 0 ? cell.x : cell.y;
}
float& alongOf(Cell3& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

// Bit `axis` of `thick`: whether entities differ along it.
template <class CellT>
struct Flattened {
  static constexpr int kAxes = In<CellT>::flat ? 2 : 3;
  static constexpr float kFar = 1000.0f;
  uint32_t n, thick;
  std::vector<CellT> cells;
  Float3 size{0.0f, 0.0f, 0.0f};  // of the box around them

  Flattened(uint32_t count, uint32_t thickAxes) : n(count), thick(thickAxes) {
    cells = In<CellT>::cells({Layout::uniform, {n, 1}, 0, 5 + thick});
    float* const sizes[] = {&size.x, &size.y, &size.z};
    for (int axis = 0; axis < kAxes; ++axis) {
      float low = kFar, high = -kFar;
      for (CellT& cell : cells) {
        float& place = alongOf(cell, axis);
        if (!(thick >> axis & 1u)) place = 42.0f;
        low = std::min(low, place);
        high = std::max(high, place);
      }
      *sizes[axis] = high - low;
    }
  }
  bool isLine() const { return (thick & (thick - 1)) == 0; }  // or a point
};

// Calls check(data) for one and for many entities, with every choice of axes along which they do not differ.
template <class CellT, class Check>
void forEachFlatBox(const Check& check) {
  for (const uint32_t n : {1u, 1000u}) {
    for (uint32_t thick = 0; thick + 1 < 1u << Flattened<CellT>::kAxes; ++thick) {
      SCOPED_TRACE(std::to_string(n) + " entities, axes " + std::to_string(thick));
      check(Flattened<CellT>(n, thick));
    }
  }
}

template <class CellT>
class FlatBoxes : public testing::Test {};
TYPED_TEST_SUITE(FlatBoxes, Dimensions);

TYPED_TEST(FlatBoxes, ExactSearchesFindWhatBruteForceFinds) {
  using In = test::In<TypeParam>;
  forEachFlatBox<TypeParam>([](const Flattened<TypeParam>& data) {
    const cpu::NDimensions chosen = cpu::chooseDimensions(data.n, data.size, 3.0f);
    ASSERT_GE(chosen.cells(), data.n);
    const auto cells = cpu::padded(data.cells, chosen);
    const GridShape shape{chosen.columns, chosen.rows, chosen.slabs};
    for (const Method method : {Method::rows, Method::frozenRows, Method::packedRows, Method::builtRows}) {
      EXPECT_EQ(checkGather(shape, cells, In::queries(cells, 200, data.thick), method, {2}), "");
    }
  });
}

TYPED_TEST(FlatBoxes, HaveFewLinesAlongAnAxisWithoutALength) {
  forEachFlatBox<TypeParam>([](const Flattened<TypeParam>& data) {
    const bool inX = data.thick & 1u, inY = data.thick & 2u;
    const cpu::NDimensions exact = cpu::chooseDimensions(data.n, data.size, 3.0f);
    const cpu::NDimensions window = cpu::chooseWindowDimensions(data.n, data.size);
    ASSERT_GE(window.cells(), data.n);
    if (!inX && data.thick != 0) {
      EXPECT_EQ(window.columns, 1u);
    }
    if (!inY) {
      EXPECT_EQ(exact.rows, 1u);
      EXPECT_EQ(window.rows, 1u);
    }
    if (data.isLine()) {
      EXPECT_EQ(window.cells(), data.n);
    }
  });
}

// On a line the window along it is all that there is to see.
TYPED_TEST(FlatBoxes, WindowsMissNobodyOnALine) {
  forEachFlatBox<TypeParam>([](const Flattened<TypeParam>& data) {
    if (!data.isLine()) return;
    const cpu::NDimensions chosen = cpu::chooseWindowDimensions(data.n, data.size);
    const auto cells = cpu::padded(data.cells, chosen);
    const auto pairs = [&](Around how) {
      const auto found =
          In<TypeParam>::around(kDevice)({2}, {chosen.columns, chosen.rows, chosen.slabs}, cells, 3.0f, how);
      return std::accumulate(found.visits.begin(), found.visits.end(), uint64_t{0});
    };
    EXPECT_EQ(pairs(Around::adaptiveWindow), pairs(Around::bruteForce));
  });
}

}  // namespace
}  // namespace gw::test
