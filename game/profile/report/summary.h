// What a session found, in sentences: for the terminal and for the top of the page.
#pragma once

#include <string>
#include <vector>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// At least one, plain text, each with its full stop.
std::vector<std::string> summaryOf(const Report& report);

}  // namespace gw::profile
