// Charts of bars that lie, one a row: shares of a whole, or one value with its interval.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/profile/report/chart.h"

namespace gw::profile {

struct Segment {
  double value;
  size_t style;
  std::string label;  // shown where there is room
};

struct BarRow {
  std::string group;  // heads the rows that follow when it differs from the one before
  std::string label;
  std::vector<Segment> segments;  // one after the other
  std::optional<Estimate> interval = {};
  std::string end;  // the value in words, behind the bar
};

// `from`: where bars begin. `mark`: a line across all of them.
std::string barPicture(const Words& words, std::span<const Key> keys, const Axis& axis, std::span<const BarRow> rows,
                       double from, std::optional<double> mark = {});

}  // namespace gw::profile
