// Ticks and what the rules count, as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace gw {

std::string minutesSeconds(uint32_t ticks);     // 4530 -> 1:15
std::string minutesTenths(uint32_t ticks);      // 4530 -> 1:15.5
std::string multiplierText(uint32_t tenths);    // 124 -> x12.4
double framesPerSecond(uint32_t frameTime_us);  // 16667 -> 60.0; 0 -> 0

}  // namespace gw
