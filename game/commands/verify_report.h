// What verify says: to people, as JSON, and as the XML that continuous integration reads of JUnit.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "game/commands/verify_run.h"

namespace gw {

// Results on stdout unless quiet; what failed on stderr.
void sayOutcome(const Outcome& outcome, bool quiet);

nlohmann::ordered_json outcomeJson(const Outcome& outcome);

// One test a replay. What is equal has passed, a difference is a failure, what could not be compared is an error.
std::string junitXml(const std::vector<Outcome>& outcomes);

}  // namespace gw
