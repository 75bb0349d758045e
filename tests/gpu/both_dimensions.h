// The probes and helpers of two and three dimensions under one name, for tests that hold in both.
#pragma once

#include <gtest/gtest.h>

#include "tests/gpu/neighbours/gather_checker.h"

namespace gw::test {

template <class CellT>
struct In;

template <>
struct In<Cell> {
  using Query = test::Query;
  static constexpr bool flat = true;
  static std::vector<Cell> cells(const CellSpec& spec) { return makeCells(spec); }
  static std::vector<Query> queries(const std::vector<Cell>& cells, uint32_t count, uint64_t seed) {
    return makeQueries(cells, count, seed);
  }
  static auto upkeep(const Probes& device) { return device.upkeep; }
  static auto report(const Probes& device) { return device.report; }
  static auto around(const Probes& device) { return device.gatherAround; }
  static auto lists(const Probes& device) { return device.lists; }
  static float along(const Cell& cell, int axis) { return axis == 0 ? cell.x : axis == 1 ? cell.y : 0.0f; }
};

template <>
struct In<Cell3> {
  using Query = Query3;
  static constexpr bool flat = false;
  static std::vector<Cell3> cells(const CellSpec& spec) { return makeCells3(spec); }
  static std::vector<Query3> queries(const std::vector<Cell3>& cells, uint32_t count, uint64_t seed) {
    return makeQueries3(cells, count, seed);
  }
  static auto upkeep(const Probes& device) { return device.upkeep3; }
  static auto report(const Probes& device) { return device.report3; }
  static auto around(const Probes& device) { return device.gatherAround3; }
  static auto lists(const Probes& device) { return device.lists3; }
  static float along(const Cell3& cell, int axis) { return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z; }
};

using Dimensions = ::testing::Types<Cell, Cell3>;

}  // namespace gw::test
