// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace gw {

std::string withCommas(uint64_t number);        // 1234567 -> 1,234,567
std::string minutesSeconds(uint32_t ticks);     // 4530 -> 1:15
std::string minutesTenths(uint32_t ticks);      // 4530 -> 1:15.5
std::string oneDecimal(double number);          // 58.34 -> 58.3
std::string twoDecimals(double number);         // 1.234 -> 1.23
std::string multiplierText(uint32_t tenths);    // 124 -> x12.4
std::string upperCase(std::string text);        // ASCII
double framesPerSecond(uint32_t frameTime_us);  // 16667 -> 60.0; 0 -> 0

}  // namespace gw
