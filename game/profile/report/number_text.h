// Figures as the report's page and pictures show them.
#pragma once

#include <cstdint>
#include <string>

#include "host/platform/statistics.h"

namespace gw::profile {

std::string wholeText(double number);       // 1234567.4 -> 1,234,567
std::string figureText(double number);      // four digits that count: 12.34, 0.01234, 1,235; NaN is an en dash
std::string estimateText(const Estimate&);  // "1.970 (1.930 to 2.010)", or the value alone
std::string enemiesText(uint32_t count);    // 1 enemy, 8,192 enemies
std::string plural(uint64_t count, const char* noun);  // 1 run, 2 runs

}  // namespace gw::profile
