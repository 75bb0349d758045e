// report.html: the report as one page that needs nothing but itself.
#pragma once

#include <span>
#include <string>

#include "game/profile/metrics/report.h"
#include "game/profile/report/plots.h"

namespace gw::profile {

// With these pictures in it. Light and dark as the reader's system asks for; no script, nothing from a network.
std::string reportHtml(const Report& report, std::span<const Plot> plots);

}  // namespace gw::profile
