// The pictures of a report.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"

namespace gw::profile {

struct Plot {
  std::string name;              // of its file, without .svg
  std::string caption;           // one sentence: what it shows
  std::string svg;               // whole
  std::optional<size_t> ofCase;  // none: of all cases
};

// Those of all cases come first. What was not measured has a picture that says so.
std::vector<Plot> plotsOf(const Report& report);

}  // namespace gw::profile
