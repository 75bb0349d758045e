// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace gw {

std::string withCommas(uint64_t number);        // 1234567 -> 1,234,567
std::string groupThousands(std::string whole);  // the same for the text of a whole number: -1234 -> -1,234
std::string oneDecimal(double number);          // 58.34 -> 58.3
std::string twoDecimals(double number);         // 1.234 -> 1.23
std::string hexadecimal(uint64_t number);       // 16 digits, as hashes are shown
std::string upperCase(std::string text);        // ASCII

}  // namespace gw
