// The tables of report.html, each a whole element.
#pragma once

#include <string>

#include "game/profile/metrics/report.h"

namespace gw::profile {

std::string machineTable(const Machine& machine);
std::string setupTable(const Report& report);
std::string contenderTable(const Case& of);
std::string metricTable(const Case& of);
std::string stageTable(const Case& of);     // empty where no stage was timed
std::string speedUpTable(const Case& of);   // empty where there was nothing to compare with
std::string runTable(const Contender& of);  // every run's own values
std::string growthTable(const Report& report);
std::string definitionList();

}  // namespace gw::profile
