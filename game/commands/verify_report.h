// The results of verify: for people, as JSON, and as the XML of JUnit that continuous integration reads.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "game/commands/verify_run.h"

namespace gw {

// Results on stdout unless quiet; what failed on stderr.
void sayOutcome(const Outcome& outcome, bool quiet);

nlohmann::ordered_json outcomeJson(const Outcome& outcome);

// One test per replay: equal ones pass, a difference is a failure, and what could not be compared is an error.
std::string junitXml(const std::vector<Outcome>& outcomes);

}  // namespace gw
